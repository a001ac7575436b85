// The folder of a batch: the data set, and the folder .batch with everything that resuming needs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/os/file.h"
#include "core/run/batch/journal.h"

namespace taxel {

/// Locks the folder while it exists.
class BatchFolder {
 public:
  /// Creates the folder if needed. Throws Error naming it: another process writes into it, it has a data set or other
  /// files of something else, or cannot be written.
  explicit BatchFolder(const std::filesystem::path& folder);

  [[nodiscard]] std::filesystem::path journal() const { return own_ / "journal"; }
  [[nodiscard]] std::filesystem::path shards() const { return own_ / "shards"; }
  [[nodiscard]] std::filesystem::path runs() const { return folder_ / "runs"; }
  /// Returns an empty folder in which the data set is written.
  [[nodiscard]] std::filesystem::path empty_staging() const;
  /// Moves the data set from the staging folder to its place; meta is moved last, so that a set with meta is complete.
  /// Throws Error naming a file that cannot be moved.
  void publish() const;
  /// Removes shards and staging, after the journal says that the data set is complete.
  void clean() const;

 private:
  std::filesystem::path folder_, own_;
  os::File lock_;
};

}  // namespace taxel
