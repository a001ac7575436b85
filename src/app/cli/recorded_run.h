// A run that `taxel sweep` or `taxel run` recorded, with the scene that lies beside it: its contacts can be computed
// again.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

struct RecordedRun {
  std::string file;
  Recording recording;
  std::size_t sensor = 0;
  std::unique_ptr<Simulator> simulator;  ///< null before load_scene()
};

/// A folder, or its readings.npz. `geom`: of the sensor that is asked about; empty where there is one. Throws Error.
RecordedRun read_run(const std::filesystem::path& path, const std::string& geom);

/// The scene beside the recording. Throws Error where it is missing, or is not the one that was recorded.
void load_scene(RecordedRun& run);

/// As Simulator::contact_at() takes them. Needs load_scene().
struct RowPoses {
  std::vector<Pose> X_WM, X_WG;
};
RowPoses poses_of(const RecordedRun& run, const RecordedRow& row);

}  // namespace taxel::cli
