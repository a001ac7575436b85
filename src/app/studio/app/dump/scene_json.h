// State dump of the running scene: the values that the user can set, the scenario, the study, and the data set.
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
/// Returns {"folder", "bits", "reading", "episodes", "failed", "listed": numbers of the listed episodes, "parameters",
/// "chosen": index, "curves": {"episode", "rows", "largest", "problem"} or null, "replay": {"episode", "rows", "of",
/// "different", "largest", "text"} or null}. "folder" is empty if no data set is open.
std::string data_set_to_state(const ui::App& app);

}  // namespace taxel::studio
