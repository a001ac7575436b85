// Runs a scenario around a layout, as `taxel sweep` and `taxel play` do, and the report of a recorded run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_layout.h"
#include "app/cli/recorder.h"
#include "app/cli/report_writer.h"
#include "core/document/scenario/scenario.h"
#include "core/run/lead.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

/// The report of `taxel sweep`, `taxel play` and `taxel run`, and the file sweep.json that is written with the data.
struct RecordingReport {
  std::string command;                 ///< "sweep", "play" or "run"
  std::optional<Scenario> scenario;    ///< empty for "run"
  std::string scene;                   ///< name of the scene file of "run"
  double seconds = 0;                  ///< requested duration of "run" [s]
  std::vector<SensorModelPtr> models;  ///< parallel to the recording's sensors
  const Recording& recording;
  RunCost cost;
  double model_seconds = 0;        ///< wall time of samples, fields and tets [s]
  std::vector<std::string> files;  ///< names of the written files; empty without --out
  std::string folder;
  std::vector<std::vector<std::string>> touched = {};  ///< geoms that each sensor can touch, by sensor
  LeadRequest lead = {};                               ///< start of the scene of "run", and files that lead the scene

  /// Writes the content of sweep.json and the times of this run.
  void visit(ReportWriter& w) const;
  /// Writes scenario, seed, versions and summary, which are equal in two runs with the same input.
  void visit_reproducible(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

/// Returns the text of sweep.json, which visit_reproducible() writes.
std::string sweep_file_json(const RecordingReport& report);

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
