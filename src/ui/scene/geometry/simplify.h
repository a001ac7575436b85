// A coarser mesh of about the same shape, where drawing every triangle would take too long.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {

/// All vertices within a cell of a grid become one, their mean; faces that lose a corner vanish, of equal ones the
/// first stays, and all look the way they did (Rossignac, Borrel 1993, "Multi-resolution 3D approximations for
/// rendering complex scenes"). The cells are chosen for about `faces` triangles on an evenly meshed surface; no point
/// moves further than a cell's diagonal. The mesh itself where nothing would be left. O(faces log faces).
TriMeshPtr simplify(const TriMeshPtr& mesh, int faces);

}  // namespace taxel::ui
