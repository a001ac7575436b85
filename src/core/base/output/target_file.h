// The file that output is written to. How it is written depends on the target that exists:
//
//   nothing, or a link to nothing   a temporary file in the same folder is renamed, so that a reader sees no file or
//   all a file                          the same; the new file gets the owner, the group and the rights of the old one
//   a file with several names, or   overwritten after the new content is complete in a temporary file and the disk has
//   whose owner cannot be kept      made room: the other names, the owner and the access list stay
//   a link                          as the file behind it; the link stays
//   a device, a pipe, this          written into
//   program's own standard output
//   a folder, a disk                refused
//
// All bytes are on the disk before the rename (fsync of the file, then of its folder), so that a reader sees the old
// file or the new one after a power failure as well.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/os/file.h"

namespace taxel {

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

}  // namespace taxel
