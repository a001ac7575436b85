// The geoms of a model as a viewer draws them.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/run/frame.h"

namespace taxel {

/// Triangles of a geom's surface, frame G, fine enough to look round; null for what is not drawn. A signed distance
/// function shows the mesh that MuJoCo made of it.
TriMeshPtr drawn_mesh(const mjModel& m, int geom);

/// The same of MuJoCo's shapes that need no more than a size (mjtGeom): sphere, capsule, cylinder, ellipsoid, box; else
/// null.
TriMeshPtr drawn_primitive(int type, const dvec3& size);

/// Every geom that is not fully transparent, in model order; `geoms` gets its number in the model.
std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms);

}  // namespace taxel
