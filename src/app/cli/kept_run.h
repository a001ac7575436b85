// Journal of a run on disk, so that a killed run loses no complete row.
#pragma once

#include <memory>
#include <string>

#include "app/cli/console.h"
#include "core/sim/host/recording_journal.h"

namespace taxel::cli {

/// Writes the rows of a run with the output folder `out` to OUT/unfinished.rows and OUT/unfinished.npz while it runs.
/// Rows of an earlier run that was killed are written next to OUT first, with a warning that names the folder.
class KeptRun {
 public:
  /// Writes nothing if `out` is empty. Warns if the rows of an earlier run cannot be read or written.
  KeptRun(const std::string& out, Console& console);
  /// Removes the journal, because the run was written or has failed.
  ~KeptRun();
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  /// Appends the new steps of `recording`. If that fails, warns and stops writing.
  void follow(const Recording& recording);

 private:
  Console& console_;
  std::unique_ptr<RecordingJournal> journal_;
};

}  // namespace taxel::cli
