#include "core/base/files.h"

#include <fmt/format.h>
#include <mbedtls/md.h>

#include <array>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/os/file.h"
#include "core/base/output.h"

namespace taxel {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path, std::uint64_t max_bytes) {
  const auto too_large = [&] {
    return Error(path.string(), fmt::format("is larger than {} bytes, the most that is read", max_bytes));
  };
  const auto unreadable = [&](int why) {
    return Error(path.string(), fmt::format("cannot be read: {}", os::error_text(why)));
  };
  const os::File in(path, os::Open::read);
  if (os::is_missing(in.error())) throw Error(path.string(), "no such file");
  if (os::has_no_file(in.error())) throw Error(path.string(), "is not a regular file");
  if (!in.is_open()) throw unreadable(in.error());
  const os::Kind kind = in.kind();
  if (kind == os::Kind::folder) throw Error(path.string(), "is a folder, not a file");
  if (kind != os::Kind::file) throw Error(path.string(), "is not a regular file");
  const std::uint64_t size = in.size();
  if (size > max_bytes) throw too_large();
  std::string bytes;
  bytes.reserve(size + 1);
  if (const int why = in.read_all(bytes, max_bytes); why != 0) throw unreadable(why);
  if (bytes.size() > max_bytes) throw too_large();
  return bytes;
}

std::string read_start(const fs::path& path, std::size_t size) {
  const os::File in(path, os::Open::read);
  std::string bytes;
  if (!in.is_open() || in.kind() != os::Kind::file || in.read_at(bytes, 0, size) != 0) return "";
  return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  TargetFile(path).write(bytes);
}

void make_folder(const fs::path& path) {
  if (const int why = os::create_folders(path, {}); why != 0)
    throw Error(path.string(), fmt::format("folder cannot be made: {}", os::error_text(why)));
  os::Status status;
  if (os::look_at(path, status) != 0 || status.kind != os::Kind::folder)
    throw Error(path.string(), "is a file, a folder is needed");
}

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (mbedtls_md(mbedtls_md_info_from_type(MBEDTLS_MD_SHA256), data, bytes.size(), digest.data()) != 0)
    throw std::runtime_error("SHA-256 failed");
  std::string hex;
  for (const unsigned char byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace taxel
