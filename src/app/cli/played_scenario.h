// Runs a scenario around a layout, as `taxel sweep` and `taxel play` do.
#pragma once

#include <string>

#include "app/cli/command.h"
#include "core/document/scenario/scenario.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

struct PlayedScenario {
  std::string command;  ///< that asks for it
  std::string file;     ///< in `out`, for scenario, seed, versions and summary
  Scenario scenario;
  std::string layout;  ///< file; empty: the built-in fingertip
  LayoutOptions over;
  std::string out;             ///< folder for the recording; empty: none is written
  bool tactile_state = false;  ///< it has tactile_state.jsonl too
};

/// Records it, writes the recording, and prints what was recorded. The exit status; throws Error for bad input.
int play(const PlayedScenario& played, Console& console);

/// Warns of a depth beyond the pad of the sensor, where no pad model is valid. Returns whether it did.
bool warn_of_depth(const Scenario& scenario, const SensorModel& model, Console& console);

}  // namespace taxel::cli
