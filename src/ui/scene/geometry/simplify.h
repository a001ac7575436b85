// Simplifies a mesh for drawing if drawing every triangle would take too long.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {

/// Returns a coarser mesh (Rossignac, Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes").
/// All vertices within a cell of a grid are replaced by their mean. Faces that lose a corner are removed, only the
/// first of equal faces remains, and the orientation of faces is preserved. The size of the cells gives about `faces`
/// triangles on an evenly meshed surface; no point moves farther than the diagonal of a cell. Returns the mesh itself
/// if no face would remain. Cost: O(faces log faces).
TriMeshPtr simplify(const TriMeshPtr& mesh, int faces);

}  // namespace taxel::ui
