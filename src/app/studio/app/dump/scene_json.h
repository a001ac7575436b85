// State dump of the running scene: the values that the user can set, the scenario, and the study.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns {"body": ..., "actuators": [{"name", "value"}], "joints": ..., "keyframes": ..., "mocaps": ...,
/// "equalities": ..., "hand": ..., "attached": ...}, or null without a simulation.
std::string scene_to_json(const ui::App& app);
/// Returns {"edited": the document's scenario in file format, "running": the scenario of the running scene, "selected":
/// index of a waypoint, "way_points": [{"at": world, "pixel"}]}, or null if no scenario runs.
std::string scenario_to_state(const ui::App& app);
/// Returns {"busy", "problem", "runs": [{"values", "rows", "largest", "error"}]}. "runs" is empty if no study was run.
std::string study_to_state(const ui::App& app);

}  // namespace taxel::studio
