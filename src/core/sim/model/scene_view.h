// The geoms of a model for drawing: their meshes, colours and groups.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/run/frame.h"

namespace taxel {

/// Returns the triangles of a geom's surface, frame G, fine enough to appear smooth; null for a geom that is not drawn.
/// A signed distance function has the mesh that MuJoCo built for it.
TriMeshPtr drawn_mesh(const mjModel& m, int geom);

/// Returns the triangles of a sphere, capsule, cylinder, ellipsoid or box (mjtGeom), frame G; null for other types.
TriMeshPtr drawn_primitive(int type, const dvec3& size);

/// Returns the geoms that are not fully transparent, in model order. Sets `geoms` to their numbers in the model.
std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms);

}  // namespace taxel
