// A geom that is a signed distance function, as a mesh.
#pragma once

#include <mujoco/mujoco.h>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The surface of an SDF geom, frame G: where the distance function of its plugin, with the geom's configuration, is
/// zero. It is the function that MuJoCo collides with, in the form that needs no mjData (`sdf_staticdistance`), because
/// bodies are made before any plugin has data. Marching tetrahedra in the plugin's own bounding box, edges of about
/// `edge` (0: a fortieth of its largest extent). Without a plugin MuJoCo takes the distance from the geom's mesh: then
/// that mesh. Throws Error: a plugin without these functions, a box that the surface leaves, or as make_level_set.
TriMesh sdf_mesh(const mjModel& m, int geom, double edge);

}  // namespace taxel
