#include "core/run/parquet/file_bytes.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel::parquet {

FileBytes::FileBytes(const std::filesystem::path& path) : name_(path.string()), file_(path, os::Open::read) {
  if (os::is_missing(file_.error())) throw Error(name_, "no such file");
  if (!file_.is_open()) throw Error(name_, fmt::format("cannot be read: {}", os::error_text(file_.error())));
  if (file_.kind() != os::Kind::file) throw Error(name_, "is not a regular file");
  size_ = file_.size();
}

FileBytes::FileBytes(std::string bytes, std::string name) : name_(std::move(name)), bytes_(std::move(bytes)) {
  size_ = bytes_.size();
}

std::string FileBytes::read(std::uint64_t offset, std::uint64_t size) const {
  if (offset > size_ || size > size_ - offset) throw Error(name_, "is damaged: it ends within a column");
  if (!file_.is_open()) return bytes_.substr(offset, size);
  std::string bytes;
  if (const int why = file_.read_at(bytes, offset, size); why != 0)
    throw Error(name_, fmt::format("cannot be read: {}", os::error_text(why)));
  if (bytes.size() != size) throw Error(name_, "ends earlier than when it was opened");
  return bytes;
}

}  // namespace taxel::parquet
