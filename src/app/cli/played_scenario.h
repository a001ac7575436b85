// Runs a scenario around a layout, as `taxel sweep` and `taxel play` do.
#pragma once

#include <string>

#include "app/cli/layout_options.h"
#include "core/document/scenario/scenario.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// A scenario with all options of its run.
struct PlayedScenario {
  std::string command;  ///< name of the command
  std::string file;     ///< name in `out` of the file with scenario, seed, versions and summary
  Scenario scenario;
  std::string layout;  ///< layout file; the built-in fingertip if empty
  LayoutOptions over;
  std::string out;   ///< folder for the recording; nothing is written if empty
  ExtraFiles extra;  ///< written in addition
  bool error_bars = false;
};

/// Runs and records the scenario, writes the recording and prints its report. Returns the exit status. Throws Error for
/// bad input.
int play(const PlayedScenario& played, Console& console);

/// Warns of a depth beyond the pad of the sensor, at which no pad model is valid. Returns whether it warned.
bool warn_of_depth(const Scenario& scenario, const SensorModel& model, Console& console);

}  // namespace taxel::cli
