// A file that is written piece by piece, and is complete or absent.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/os/file.h"

namespace taxel {

/// Writes into a folder that the caller moves to its place when all files are complete.
class StreamedFile {
 public:
  /// Creates the file and its folders. Throws Error naming the file.
  explicit StreamedFile(std::filesystem::path path);
  /// Throws Error naming the file if the bytes cannot be written.
  void write(std::string_view bytes);
  /// Waits until all bytes are on the disk, and closes the file. Throws Error naming the file.
  void finish();

 private:
  [[noreturn]] void fail(int why) const;

  std::filesystem::path path_;
  os::File file_;
};

}  // namespace taxel
