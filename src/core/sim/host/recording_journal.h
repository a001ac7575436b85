// A journal on disk of a recording in progress, so that a killed process loses no complete row.
//
// A journal is two files with a common base path. BASE.npz is a readings.npz up to and including the first row, which
// describes the columns. BASE.rows begins with the target path of the recording; then there is one entry for each later
// step and one for each step back. An entry is a kind, its numbers and a checksum, and is passed to the operating
// system as a whole. So a killed process leaves complete entries, and at most one entry whose checksum is wrong.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/os/file.h"
#include "core/run/recording/recording.h"

namespace taxel {

class RecordingJournal {
 public:
  /// Creates BASE.rows and locks it. `target` is the path of the finished recording. Throws Error if the file cannot be
  /// created, or another process has locked it.
  RecordingJournal(std::filesystem::path base, const std::string& target);
  /// Closes the files without removing them.
  ~RecordingJournal() = default;
  RecordingJournal(const RecordingJournal&) = delete;
  RecordingJournal& operator=(const RecordingJournal&) = delete;

  /// Writes the steps that `recording` has gained since the last successful call. Throws Error if they cannot be
  /// written: the entries on the disk stay complete, and the next call tries again.
  void follow(const Recording& recording);
  /// Writes that the recording was cut to the steps of `recording`. Throws Error as follow() does.
  void cut_to(const Recording& recording);
  /// Returns the number of rows that are on the disk.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Removes the files, after the recording was written or discarded.
  void remove();

 private:
  void write(std::vector<double> entry);
  void write_head(const Recording& recording);
  void write_cut();

  std::filesystem::path base_;
  os::File file_;
  bool has_head_ = false;
  std::uint64_t bytes_ = 0;           ///< size of BASE.rows up to its last complete entry
  std::size_t steps_ = 0, rows_ = 0;  ///< number of steps and rows that are on disk
  std::optional<std::size_t> cut_;    ///< number of steps of a cut that could not be written yet
};

/// A recording that an ended process has left.
struct LeftRecording {
  std::filesystem::path base;  ///< common base path of the two files
  std::string target;          ///< path that the recording was for
  Recording recording;         ///< at least one row
};

/// Returns the recording of a journal that no process has locked; empty if there is none with a complete row. Throws
/// Error if the files can be read but are not a journal.
std::optional<LeftRecording> read_recording_journal(const std::filesystem::path& base);

/// Returns the recordings that ended processes have left in `folder`, and removes journals without a complete row.
std::vector<LeftRecording> left_recordings(const std::filesystem::path& folder);

/// Removes both files of a journal.
void remove_recording_journal(const std::filesystem::path& base);

/// Removes the journal, and its target if the target was begun but has no complete file. Throws Error naming the
/// target.
void discard_left_recording(const LeftRecording& left);

/// Writes a left recording to its target and removes the journal. The caller sets the target if it does not trust the
/// journal's, which names any path. If the target already has files, writes to
/// TARGET-recovered, TARGET-recovered-2 and so on. Returns the path. Throws Error naming the file if writing fails; the
/// journal then remains.
std::filesystem::path write_left_recording(const LeftRecording& left);

}  // namespace taxel
