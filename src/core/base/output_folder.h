// A folder that is filled as a whole: files are collected beside it and moved in when all are there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

class OutputFolder {
 public:
  /// Makes the folder now, so that a place that cannot be written is found before the work begins. Throws Error.
  explicit OutputFolder(const std::filesystem::path& folder);
  /// Without commit() nothing stays: neither files nor a folder that was made here.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where files are put until commit().
  [[nodiscard]] const std::filesystem::path& staging() const { return staging_; }
  void write(const std::string& name, std::string_view bytes);
  /// An older file of this name goes away on commit(): it would be taken for one of this run.
  void leave_out(const std::string& name) { left_out_.push_back(name); }
  /// Moves every file into the folder, over older ones of the same name; returns their names, sorted.
  std::vector<std::string> commit();

 private:
  std::filesystem::path folder_, staging_, topmost_made_;
  std::vector<std::string> left_out_;
  bool committed_ = false;
};

}  // namespace taxel
