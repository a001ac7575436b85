// The folder of a batch: the data set, and the folder .batch with everything that resuming needs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/os/file.h"
#include "core/run/batch/journal.h"

namespace taxel {

/// Locks the folder while it exists.
class BatchFolder {
 public:
  /// Creates the folder if needed. Throws Error naming it: another process writes into it, it has a data set or other
  /// files of something else, a link in the place of its own files, or cannot be written.
  explicit BatchFolder(const std::filesystem::path& folder);

  [[nodiscard]] std::filesystem::path journal() const { return own_ / "journal"; }
  [[nodiscard]] std::filesystem::path shards() const { return own_ / "shards"; }
  [[nodiscard]] std::filesystem::path runs() const { return folder_ / "runs"; }
  /// Returns an empty folder in which the data set is written.
  [[nodiscard]] std::filesystem::path empty_staging() const;
  /// Returns the files in the staging folder, in the order of publish(): meta last, and of meta its info.json, so that
  /// a set with an info.json is complete.
  [[nodiscard]] std::vector<PublishedFile> staged_files() const;
  /// Returns those of these names in runs() that are there.
  [[nodiscard]] std::vector<PublishedFile> run_files(const std::vector<std::string>& names) const;
  /// Returns the name of the first of these files that is gone, or an empty text. Throws Error naming a file that is
  /// not as it was written.
  [[nodiscard]] std::string first_missing(const std::vector<PublishedFile>& files) const;
  /// Moves the staged files to their places. Replaces only files of `before`, the files of an earlier or interrupted
  /// call, that are as they were written. Throws Error naming another file in a place before any file is moved, or a
  /// file that cannot be moved.
  void publish(const std::vector<PublishedFile>& files, const std::vector<PublishedFile>& before) const;
  /// Removes shards and staging, after the journal says that the data set is complete.
  void clean() const;

 private:
  std::filesystem::path folder_, own_;
  os::File lock_;
};

}  // namespace taxel
