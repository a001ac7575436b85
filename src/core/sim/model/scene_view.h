// The geoms of a model for drawing: their meshes, colours and groups.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/run/frame.h"

namespace taxel {

/// Returns the geoms that are not fully transparent, in model order. Sets `geoms` to their numbers in the model.
std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms);

}  // namespace taxel
