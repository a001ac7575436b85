// Journal of a run on disk, so that a run that is killed, or whose files cannot be written, loses no complete row.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/base/output/output_folder.h"
#include "core/sim/host/recording_journal.h"

namespace taxel::cli {

/// Writes the rows of a run with the output folder `out` to OUT/unfinished.rows and OUT/unfinished.npz while it runs.
/// Rows of an earlier run that has ended early are written next to OUT first, with a warning that names the folder.
class KeptRun {
 public:
  /// Writes nothing if `out` is empty. Warns if the rows of an earlier run cannot be read or written.
  KeptRun(const std::string& out, Console& console);
  /// Removes a journal without rows. One with rows stays unless commit() has removed it.
  ~KeptRun();
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  /// Appends the new steps of `recording`. If that fails, warns once, and tries again at the next step.
  void follow(const Recording& recording);
  /// Calls put(), commits the folder and removes the journal. Returns the names of the files, none without a folder. If
  /// that fails, the collected files make room for the rows that are missing in the journal.
  std::vector<std::string> commit(std::optional<OutputFolder>& folder, const Recording& recording,
                                  const std::function<void(OutputFolder&)>& put);
  /// Returns work(). Adds to an Error where the rows are and how to get them.
  template <class Work>
  auto run(const Work& work) {
    try {
      return work();
    } catch (const Error& error) {
      throw explained(error);
    }
  }

 private:
  [[nodiscard]] Error explained(const Error& error) const;
  [[nodiscard]] std::string remedy() const;
  void remove_journal();

  std::string out_;
  Console& console_;
  std::unique_ptr<RecordingJournal> journal_;
  bool has_warned_ = false;
};

}  // namespace taxel::cli
