// Output folder that is filled as a whole: files are collected in a temporary folder and moved when all are complete.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/output/temporary_path.h"

namespace taxel {

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
