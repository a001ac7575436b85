// The meshes of geoms for drawing, which are also compared with the mesh of a layout.
#pragma once

#include <mujoco/mujoco.h>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the triangles of a geom's surface, frame G, fine enough to appear smooth; null for a geom that is not drawn.
/// A signed distance function has the mesh that MuJoCo built for it.
TriMeshPtr drawn_mesh(const mjModel& m, int geom);

/// Returns the triangles of a sphere, capsule, cylinder, ellipsoid or box (mjtGeom), frame G; null for other types.
TriMeshPtr drawn_primitive(int type, const dvec3& size);

}  // namespace taxel
