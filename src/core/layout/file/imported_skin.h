// Adds values from the skin to a layout of another program: scale, normals, cells, frame and density.
#pragma once

#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Guesses the factor from the units of a mesh file to metres: of 1, 0.001, 0.01 and 0.0254 the one with the smallest
/// mean distance between the taxels and the surface. Decides by the size of the mesh if the file lists no taxels.
double guess_scale(const ImportedLayout& imported, const TriMesh& unscaled);

/// Adds the values that the file does not give, with a note for each: normals of the nearest points of the skin, the
/// cells of a flat array over the top (+z) of the skin, the frame, and a density of at most 100000 samples.
/// `skin` is the scaled mesh. Normals that all point into the skin are turned over. Throws Error naming `file` if no
/// cell of an array is on the skin, or as check_near_skin() does.
void put_on_skin(ImportedLayout& imported, const TriMeshPtr& skin, const std::string& file);

/// Guesses the directions of the sensor: of a planar array by its taxels, of a finger by its shape and taxels
/// (guess_frame). Keeps the layout's frame if both fail. Returns a note for the user.
std::string take_frame_of(const TriMesh& skin, Layout& layout);

}  // namespace taxel
