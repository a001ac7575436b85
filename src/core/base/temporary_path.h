// Unfinished output: files and folders with a temporary name, which a process that ends early must not leave behind.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "core/base/os/file.h"

namespace taxel {

/// A file or folder that is renamed to its final name when it is complete. Its name is PREFIX + process id + ".part".
/// While the object exists, remove_temporary_paths() removes the path, and a lock on the path shows other
/// processes that it is in use.
class TemporaryPath {
 public:
  /// Removes the paths PREFIX.PID.part that ended processes have left in `folder`, then creates the path and opens it,
  /// as a file (`replace`) or a folder (`create_folder`).
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

/// A folder that is removed with the temporary paths, because it was created for output that is not complete.
class UnfinishedFolder {
 public:
  /// `folder` may be empty: then there is nothing to remove.
  explicit UnfinishedFolder(std::filesystem::path folder);
  /// Removes the folder unless keep() was called.
  ~UnfinishedFolder();
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;
  void keep();

 private:
  std::filesystem::path folder_;
};

/// Blocks remove_temporary_paths() while output is moved to its final names.
[[nodiscard]] std::unique_lock<std::recursive_mutex> lock_temporary_paths();

/// Removes all temporary paths of this process and blocks all threads that would create another one. It is meant for a
/// thread that ends the process with _exit() directly afterwards.
void remove_temporary_paths();

}  // namespace taxel
