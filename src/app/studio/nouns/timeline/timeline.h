// The timeline of the latest steps at the bottom of the window: one line with the displayed step and markers of events,
// which unfolds to tracks with their values and to the conditions that pause a run.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The timeline of recorded steps. It is no movable panel.
extern const Feature kTimeline;
/// Sets "timeline", and "history" of the simulation.
void dump_timeline(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
