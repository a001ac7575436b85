// Output: files and folders that appear at their place as a whole or not at all. TemporaryPath is an unfinished file or
// folder, TargetFile the file that output is written to, OutputFolder a folder of files that are moved into it together
// when all are complete.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
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

/// The file that output is written to. How it is written depends on the target that exists:
///
///   nothing, or a link to nothing   a temporary file in the same folder is renamed, so that a reader sees no file or
///   all a file                          the same; the new file gets the owner, the group and the rights of the old one
///   a file with several names, or   overwritten after the new content is complete in a temporary file and the disk has
///   whose owner cannot be kept      made room: the other names, the owner and the access list stay
///   a link                          as the file behind it; the link stays
///   a device, a pipe, this          written into
///   program's own standard output
///   a folder, a disk                refused
///
/// All bytes are on the disk before the rename (fsync of the file, then of its folder), so that a reader sees the old
/// file or the new one after a power failure as well.
class TargetFile {
 public:
  /// Looks at `path`. Throws Error that names `path` if it cannot be written.
  explicit TargetFile(const std::filesystem::path& path);

  /// Writes the whole content. Throws Error that names the file; a file then has its old content, and no temporary file
  /// is left.
  void write(std::string_view bytes) const;
  /// Writes the content of a complete file, which is moved or copied. Throws Error as write() does.
  void take(const std::filesystem::path& complete) const;

 private:
  enum class How { renamed, overwritten, written_into };
  /// Passes the content to a function, piece by piece, until it returns an error.
  template <class Content>
  void write_content(const Content& content) const;
  void put_in_place(const std::filesystem::path& complete, const os::File& file) const;
  void overwrite(const std::filesystem::path& complete) const;
  [[noreturn]] void fail(int why) const;

  std::filesystem::path path_, real_;  ///< the name that the caller gave, and the one behind all links
  How how_ = How::renamed;
  bool exists_ = false;
  os::Status old_;   ///< description of a target that exists
  os::File stream_;  ///< open if the target is written into
};

/// An output folder that is filled as a whole: files are collected in a temporary folder and moved when all are
/// complete.
class OutputFolder {
 public:
  /// Creates the folder now, so that a folder that cannot be written is found before the work begins. Throws Error if
  /// it cannot be written.
  explicit OutputFolder(const std::filesystem::path& folder);
  /// Removes the files that were not committed, and the folders that this object has made if they are empty.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Folder in which files are collected until commit().
  [[nodiscard]] const std::filesystem::path& staging() const { return staging_->path(); }
  void write(const std::string& name, std::string_view bytes);
  /// Calls fill(folder) with the folder in which files are collected until commit(). An Error of fill() names the final
  /// file in its place.
  void fill(const std::function<void(const std::filesystem::path&)>& fill);
  /// Removes the files that were not committed, to make room on the disk.
  void discard();
  /// Lets commit() remove an older file of this name, which would otherwise be taken for a file of this run.
  void leave_out(const std::string& name) { left_out_.push_back(name); }
  /// Moves every collected file into the folder as TargetFile::take() does, over older ones of the same name, and
  /// returns the names of files and folders, sorted. More files can be collected and committed afterwards. Other files
  /// in the folder and its subfolders stay. Throws Error before any file is moved if a folder is in the place of a
  /// file, or a file in the place of a folder.
  std::vector<std::string> commit();

 private:
  [[nodiscard]] std::vector<std::filesystem::path> collected() const;
  void check_targets(const std::vector<std::filesystem::path>& files) const;

  std::filesystem::path folder_;
  MadeFolders made_;
  std::unique_ptr<TemporaryPath> staging_;
  std::vector<std::string> left_out_;
};

}  // namespace taxel
