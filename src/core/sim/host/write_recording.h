// Writes a recording as files, as `taxel sweep` and `taxel run` do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/output_folder.h"
#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Writes a recording into `folder`, which the caller commits: readings.csv and readings.npz, calibrated.csv if a
/// sensor has a calibration, shear.csv if a sensor has shear, tactile_state.jsonl if requested, and scene.xml with its
/// meshes and layouts if `scene` is not null. Removes older files of these names. Throws Error naming the file.
void put_recording(OutputFolder& folder, const Recording& recording, const Simulator* scene, bool tactile_state);

/// Writes one file if `path` ends in .csv, .npz or .jsonl (tactile_msgs/TactileState), otherwise a folder as
/// put_recording() does. Writes completely or not at all. Throws Error naming the file.
void write_recording(const std::filesystem::path& path, const Recording& recording, const Simulator* scene);

}  // namespace taxel
