// Writes a recording as files, as `taxel sweep` and `taxel run` do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/output.h"
#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Files of a recording that are written on request.
struct ExtraFiles {
  bool tactile_state = false;  ///< tactile_state.jsonl
};

/// A JSON file about a run, which put_recording() writes next to the recording.
struct RunFile {
  std::string name;  ///< such as "sweep.json"; no file is written if empty
  std::string text;
};

/// Writes a recording into `folder`, which the caller commits: readings.csv and readings.npz, calibrated.csv if a
/// sensor has a calibration, shear.csv if a sensor has shear, slip.csv if friction sticks, the requested extra files,
/// `run`, and scene.xml with its meshes and layouts if `scene` is not null. Removes older files of these names. Throws
/// Error naming the file.
void put_recording(OutputFolder& folder, const Recording& recording, const Simulator* scene, const ExtraFiles& extra,
                   const RunFile& run);

/// Writes one file if `path` ends in .csv, .npz or .jsonl (tactile_msgs/TactileState), otherwise a folder as
/// put_recording() does. Writes completely or not at all. Throws Error naming the file, also if `path` ends in .mcap,
/// which Python writes.
void write_recording(const std::filesystem::path& path, const Recording& recording, const Simulator* scene);

}  // namespace taxel
