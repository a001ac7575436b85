// A recording as files, named and laid out as `taxel sweep` and `taxel run` do it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/output_folder.h"
#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Into `folder`, which the caller commits: readings.csv, readings.npz, calibrated.csv where a sensor has a
/// calibration, shear.csv where one is asked for, tactile_state.jsonl where that is wished (else older ones of these go
/// away), and scene.xml with its meshes and layouts where `scene` is not null. Throws Error naming the file.
void put_recording(OutputFolder& folder, const Recording& recording, const Simulator* scene, bool tactile_state);

/// One file where `path` ends in .csv, .npz or .jsonl (tactile_msgs/TactileState), written beside and renamed; else a
/// folder as put_recording() fills it, all of it or nothing. Throws Error naming the file.
void write_recording(const std::filesystem::path& path, const Recording& recording, const Simulator* scene);

}  // namespace taxel
