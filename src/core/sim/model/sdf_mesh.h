// The mesh of a geom that a plugin describes by a signed distance function.
#pragma once

#include <mujoco/mujoco.h>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Computes the surface of an SDF geom that has a plugin, frame G: the zero level of the plugin's distance function
/// with the geom's configuration. It is the function that MuJoCo collides with, in the form without mjData
/// (`sdf_staticdistance`), because bodies are built before a plugin has data. Marching tetrahedra run in the plugin's
/// bounding box with edges of about `edge` [m]; 0 means a fortieth of the largest extent of the box. Throws Error if
/// the plugin lacks these functions or the surface leaves the box, and as make_level_set() does.
TriMesh sdf_mesh(const mjModel& m, int geom, double edge);

}  // namespace taxel
