// The report of `taxel sweep`, `taxel play` and `taxel run`, and the file sweep.json that is written with the data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/recorder.h"
#include "app/cli/report_writer.h"
#include "core/document/scenario/scenario.h"
#include "core/run/lead/read_lead.h"
#include "core/sensor/sensor_model.h"

namespace taxel::cli {

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

}  // namespace taxel::cli
