// Rows of a run on disk while it runs, so that a kill loses none that are complete.
#pragma once

#include <memory>
#include <string>

#include "app/cli/console.h"
#include "core/sim/host/recording_journal.h"

namespace taxel::cli {

/// The journal of a run that writes into the folder `out`: OUT/unfinished.rows and OUT/unfinished.npz. The rows that a
/// killed run has left there are written next to OUT first, with a warning that names the folder.
class KeptRun {
 public:
  /// `out` may be empty: then nothing is kept. Warns if left rows cannot be read or written.
  KeptRun(const std::string& out, Console& console);
  /// Removes the journal: the run is written, or has failed.
  ~KeptRun();
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  /// Keeps the steps that `recording` has gained. If that fails, warns, and keeps no more.
  void follow(const Recording& recording);

 private:
  Console& console_;
  std::unique_ptr<RecordingJournal> journal_;
};

}  // namespace taxel::cli
