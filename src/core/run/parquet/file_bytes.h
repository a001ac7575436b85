// The bytes of a file that is read in parts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/os/file.h"

namespace taxel::parquet {

/// A file on the disk, or in memory.
class FileBytes {
 public:
  /// Opens a regular file. Throws Error naming the file.
  explicit FileBytes(const std::filesystem::path& path);
  /// Takes a file in memory; `name` is its name in messages. Throws nothing.
  FileBytes(std::string bytes, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Returns `size` bytes from `offset`. Throws Error naming the file if it ends before, or cannot be read.
  [[nodiscard]] std::string read(std::uint64_t offset, std::uint64_t size) const;

 private:
  std::string name_, bytes_;
  os::File file_;
  std::uint64_t size_ = 0;
};

}  // namespace taxel::parquet
