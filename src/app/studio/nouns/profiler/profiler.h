// The profiler: the time of simulation steps and of frames, split into parts.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The costs of steps and pictures.
extern const Feature kProfiler;
/// Sets "profile": the means of the costs [s].
void dump_profile(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
