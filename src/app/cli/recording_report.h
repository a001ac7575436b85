// What `taxel sweep` and `taxel run` tell of a recording: a table, a JSON object, and the sweep.json beside the data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/recorder.h"
#include "app/version/version.h"
#include "core/document/scenario/scenario.h"
#include "core/run/recording/summary.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

struct RecordingReport {
  std::string command;                 ///< "sweep" or "run"
  std::optional<Scenario> scenario;    ///< of a sweep
  std::string scene;                   ///< file name of a run's scene
  double seconds = 0;                  ///< asked for in a run [s]
  std::vector<SensorModelPtr> models;  ///< parallel to the recording's sensors
  const Recording& recording;
  RunCost cost;
  double model_seconds = 0;        ///< wall time spent on samples, fields and tets
  std::vector<std::string> files;  ///< written, when --out was given
  std::string folder;
  std::vector<std::vector<std::string>> touched = {};  ///< names of the geoms that each sensor can touch
};

/// Wall time that no sensor took [s].
double rest_of(const RunCost& cost);

std::string recording_text(const RecordingReport& report);
/// The result on stdout: what sweep.json holds, with the times of this run.
std::string recording_json(const RecordingReport& report);
/// sweep.json: scenario, seed, versions, summary; nothing that differs between two runs.
std::string sweep_file_json(const RecordingReport& report);

}  // namespace taxel::cli
