// The folder of a batch: shards and index (batch_index.h), and the folder .batch with everything that resuming needs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/os/file.h"
#include "core/run/batch/episode.h"

namespace taxel {

// The journal in that folder: which groups are finished. It makes a killed batch resume without repeating a group.
//
// The first line describes the batch, and each further line is a finished group. A line is a checksum, a space and a
// JSON object. The system gets each line as a whole, so a killed process leaves complete lines and at most one that is
// cut short, whose checksum is wrong.

/// The batch that a journal belongs to.
struct BatchIdentity {
  std::string list_sha256;  ///< JobList::sha256
  std::string program;      ///< versions of the program and of MuJoCo: others may give other bits
  BatchFormat format;
  bool operator==(const BatchIdentity&) const = default;
};

/// A file of a batch, as it was written.
struct PublishedFile {
  std::string name;  ///< path below the folder of the batch
  std::uint64_t bytes = 0;
  std::string sha256;
  bool operator==(const PublishedFile&) const = default;
};

/// The content of a journal.
struct JournalContent {
  std::optional<BatchIdentity> identity;  ///< empty if not even the first line is complete
  std::set<std::string> groups;           ///< ids of the finished groups
  std::vector<PublishedFile> files;       ///< files of the batch, see publish()
  bool is_complete = false;               ///< all of them were in place
  std::size_t broken_lines = 0;           ///< lines with a wrong checksum, which were skipped
};

/// Replays the text of a journal. Throws Error naming `file` if the text has a first line that is not of a journal, or
/// of another version of the format.
JournalContent replay_journal(const std::string& text, const std::string& file);

/// Throws Error naming the journal and the difference if it belongs to another batch.
void check_same_batch(const BatchIdentity& found, const BatchIdentity& expected, const std::string& file);

/// An open journal. Safe to use from one thread at a time.
class BatchJournal {
 public:
  /// Opens the journal of `identity`, and writes it again without broken lines if it has some. Throws Error if it
  /// belongs to another batch or cannot be written.
  BatchJournal(std::filesystem::path path, const BatchIdentity& identity);

  [[nodiscard]] const JournalContent& content() const { return content_; }
  /// Records a finished group, whose shard is on the disk. Throws Error naming the file.
  void add_group(const std::string& group);
  /// Records that the group has to run again, because its shard is not readable.
  void forget_group(const std::string& group);
  /// Records the files of the batch, before those of its index are moved to their places. Until they are, the files
  /// that they replace have to be among them, so that a killed process is continued. Throws as add_group() does.
  void publish(const std::vector<PublishedFile>& files);
  /// Records that all files are in their places.
  void complete();
  /// Records that the index has to be written again, because a file of the batch is gone.
  void reopen();

 private:
  void write(const std::string& line);
  void write_again();

  std::filesystem::path path_;
  BatchIdentity identity_;
  JournalContent content_;
  os::File file_;
};

/// Locks the folder while it exists.
class BatchFolder {
 public:
  /// Creates the folder if needed. Throws Error naming it: another process writes into it, it has a batch or other
  /// files of something else, a link in the place of its own files, or cannot be written.
  explicit BatchFolder(const std::filesystem::path& folder);

  [[nodiscard]] std::filesystem::path journal() const { return own_ / "journal"; }
  [[nodiscard]] std::filesystem::path root() const { return folder_; }
  /// Returns an empty folder in which the index is written.
  [[nodiscard]] std::filesystem::path empty_staging() const;
  /// Returns the files in the staging folder, in the order of publish(): batch.json last, so that a folder with it is
  /// complete.
  [[nodiscard]] std::vector<PublishedFile> staged_files() const;
  /// Returns those of these files of groups and jobs that are there. The names are paths below the folder.
  [[nodiscard]] std::vector<PublishedFile> result_files(const std::vector<std::string>& names) const;
  /// Returns the name of the first of these files that is gone, or an empty text. Throws Error naming a file that is
  /// not as it was written.
  [[nodiscard]] std::string first_missing(const std::vector<PublishedFile>& files) const;
  /// Removes batch.json, since the batch is not complete any more, if it is one of these files.
  void withdraw(const std::vector<PublishedFile>& files) const;
  /// Moves the staged files to their places. Replaces only files of `before`, the files of an earlier or interrupted
  /// call, that are as they were written; shards and runs of `before` stay. Throws Error naming another file in a place
  /// before any file is moved, or a file that cannot be moved.
  void publish(const std::vector<PublishedFile>& files, const std::vector<PublishedFile>& before) const;
  /// Removes the staging folder, after the journal says that the batch is complete.
  void clean() const;

 private:
  std::filesystem::path folder_, own_;
  os::File lock_;
};

}  // namespace taxel
