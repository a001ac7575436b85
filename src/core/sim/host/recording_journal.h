// Rows of a recording on disk while it is made, so that a process that is killed loses none that were complete.
//
// Two files with a common base path: BASE.npz is a readings.npz up to and including the first row, which says what the
// columns are. BASE.rows begins with the path that the recording is for; then come one entry per later step and one per
// step back. An entry is a kind, its numbers and a checksum, and is passed to the operating system as a whole, so a
// killed process leaves complete entries and at most one that its checksum refuses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

class RecordingJournal {
 public:
  /// Creates BASE.rows and locks it. `target`: the path that the recording is for. Throws Error if the file cannot be
  /// created, or another process holds it.
  RecordingJournal(std::filesystem::path base, const std::string& target);
  /// Leaves the files.
  ~RecordingJournal();
  RecordingJournal(const RecordingJournal&) = delete;
  RecordingJournal& operator=(const RecordingJournal&) = delete;

  /// Writes the steps that `recording` has gained since the last call. Throws Error if they cannot be written.
  void follow(const Recording& recording);
  /// The recording was cut to these steps. Throws Error as follow() does.
  void cut_to(const Recording& recording);
  /// Removes the files: the recording is written, or nobody wants it.
  void remove();

 private:
  void write(std::vector<double> entry);

  std::filesystem::path base_;
  int file_ = -1;
  bool has_head_ = false;
  std::size_t steps_ = 0, rows_ = 0;  ///< number of steps and rows that are on disk
};

/// A recording that an ended process has left.
struct LeftRecording {
  std::filesystem::path base;  ///< of the journal's two files
  std::string target;          ///< path that the recording was for
  Recording recording;         ///< at least one row
};

/// Returns the recording of a journal that no process holds; empty if there is none with a complete row. Throws Error
/// if the files can be read but are none of a journal.
std::optional<LeftRecording> read_recording_journal(const std::filesystem::path& base);

/// Returns the recordings that ended processes have left in `folder`, and removes journals without a complete row.
std::vector<LeftRecording> left_recordings(const std::filesystem::path& folder);

/// Removes both files of a journal.
void remove_recording_journal(const std::filesystem::path& base);

/// Removes the journal, and a target that was begun and holds no complete file. Throws Error naming the target.
void discard_left_recording(const LeftRecording& left);

/// Writes a left recording as its target, or as TARGET-recovered, TARGET-recovered-2 and so on if the target holds
/// files already, and removes the journal. Returns the path. Throws Error naming the file; then the journal stays.
std::filesystem::path write_left_recording(const LeftRecording& left);

}  // namespace taxel
