// The panel of settings of the running scene: layouts on geoms, actuators, joints, keyframes, mocap bodies and equality
// constraints.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Actuators, joints, bodies and keyframes of a scene.
extern const Feature kControls;
/// Sets "scene": bodies, and all values that the user can set.
void dump_controls(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
