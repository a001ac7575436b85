// Values that the skin adds to a layout of another program: scale, normals, cells, frame and density.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/layout_format.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The factor from the units of a mesh file to metres: of 1, 0.001, 0.01 and 0.0254 the one with which the taxels are
/// closest to the surface in the mean; by the size of the mesh where the file lists no taxels. A guess: to be shown.
double guess_scale(const ImportedLayout& imported, const TriMesh& unscaled);

/// Adds the values that the file does not give, with a note for each: normals of the nearest points of the skin, the
/// cells of a flat array over the top (+z) of the skin, the frame, and a density of at most 100000 samples.
/// `skin`: the scaled mesh. Throws Error naming `file` if no cell of an array is on the skin.
void put_on_skin(ImportedLayout& imported, const TriMeshPtr& skin, const std::string& file);

/// Guesses where the sensor points and where it touches: a planar array by its taxels, a finger by its shape and its
/// taxels (guess_frame). Keeps the layout's frame where neither tells. Returns the note that says so.
std::string take_frame_of(const TriMesh& skin, Layout& layout);

}  // namespace taxel
