// Unfinished output: files and folders with a temporary name, which a process that ends early must not leave behind.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/os/file.h"

namespace taxel {

/// A file or folder that is renamed to its final name when it is complete. Its name is PREFIX, the process id and a
/// number that nobody can guess: PREFIX + "123-0a1b2c3d.part". Nothing that exists before is opened, and no link is
/// followed. While the object exists, remove_temporary_paths() removes the path, and a lock on the path shows other
/// processes that it is in use.
class TemporaryPath {
 public:
  /// Removes the paths PREFIX.PID-NUMBER.part that ended processes have left in `folder`, then creates the path and
  /// opens it: as a file (`create`, `create_private`) or a folder (`create_folder`).
  TemporaryPath(const std::filesystem::path& folder, const std::string& prefix, os::Open how);
  /// Removes the path with all that it contains, if it still exists.
  ~TemporaryPath();
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(const TemporaryPath&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const os::File& file() const { return file_; }  ///< not open if the path could not be created
  void close() { file_.close(); }

 private:
  std::filesystem::path path_;
  os::File file_;
};

/// Folders that this process has made for its output. Those that are empty at the end of the object, or at the end of
/// the process by a signal, are removed again. A folder that somebody else has made, or put something into, stays.
class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  /// Makes a folder and its parents. Throws Error naming the folder as make_folder() does.
  void make(const std::filesystem::path& folder);

 private:
  std::vector<std::filesystem::path> folders_;  ///< in the order in which they were made
};

/// Blocks remove_temporary_paths() while output is moved to its final names, for a second at most.
[[nodiscard]] std::unique_lock<std::recursive_timed_mutex> lock_temporary_paths();

/// Removes all temporary paths of this process, and the empty ones of its made folders, and blocks all threads that
/// would create another one. It is meant for a thread that ends the process with _exit() directly afterwards. Removes
/// nothing if output is being moved to its final names and this takes longer than a second.
void remove_temporary_paths();

}  // namespace taxel
