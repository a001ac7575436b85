// A run that `taxel sweep` or `taxel run` recorded, with its scene, from which its contacts can be computed again.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

struct RecordedRun {
  std::string file;  ///< path of readings.npz
  Recording recording;
  std::size_t sensor = 0;                ///< index of the requested sensor
  std::unique_ptr<Simulator> simulator;  ///< the scene, or null before load_scene()
};

/// Returns the index of the sensor on `geom`, or of the only sensor with taxels if `geom` is empty. Throws Error naming
/// `file` and its sensors, also for a soft geom without taxels.
std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file);

/// Reads a folder, or its readings.npz. `geom` as for sensor_of(). Throws Error.
RecordedRun read_run(const std::filesystem::path& path, const std::string& geom);

/// Loads scene.xml, which is in the folder of the recording. Throws Error if it is missing or is not the recorded
/// scene.
void load_scene(RecordedRun& run);

/// The arguments of Simulator::contact_at(): poses of all sensors and of all geoms.
struct RowPoses {
  std::vector<Pose> X_WM, X_WG;
};
/// Returns the poses of a row. Needs load_scene().
RowPoses poses_of(const RecordedRun& run, const RecordedRow& row);

}  // namespace taxel::cli
