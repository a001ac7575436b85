// The folder that `taxel study` writes: runs.csv and a file per run.
#pragma once

#include <filesystem>
#include <vector>

#include "core/run/plot/run_chart.h"

namespace taxel {

struct StudyFolder {
  std::vector<StudiedRun> runs;  ///< at least one
  std::size_t columns = 1;       ///< number of panels in a row: values of the second parameter, or near a square
};

/// Returns true if a folder has runs.csv.
[[nodiscard]] bool is_study_folder(const std::filesystem::path& folder);

/// Reads the runs that runs.csv lists, each from its archive of arrays, or from its table if it has none. Throws
/// Error(file, "line 3", ...) if runs.csv is not such a list or names a file outside of the folder.
[[nodiscard]] StudyFolder read_study_folder(const std::filesystem::path& folder);

}  // namespace taxel
