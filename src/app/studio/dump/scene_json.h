// What a hand can set in the running scene, as the state of the window tells it.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// {"body": ..., "actuators": [{"name", "value"}], "joints": ..., "keyframes": ..., "mocaps": ..., "equalities": ...,
/// "hand": ..., "attached": ...}; null without a simulation.
std::string scene_to_json(const ui::App& app);
/// {"edited": the document's scenario as files have it, "running": that of the scene that runs, "selected": way point,
/// "way_points": [{"at": world, "pixel"}]}; null where no scenario runs.
std::string scenario_to_state(const ui::App& app);
/// {"busy", "problem", "runs": [{"values", "rows", "largest", "error"}]}; null where none were run.
std::string study_to_state(const ui::App& app);

}  // namespace taxel::studio
