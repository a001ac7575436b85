#include "core/base/files.h"

#include <fmt/format.h>

#include <system_error>

#include "core/base/error.h"
#include "core/base/os/file.h"
#include "core/base/temporary_path.h"

namespace taxel {
namespace fs = std::filesystem;

namespace {

void sync_folder(const fs::path& folder) {
  const os::File file(folder.empty() ? "." : folder, os::Open::folder);
  if (file.is_open()) static_cast<void>(file.sync());  // the new file is in place: a failure changes nothing
}

}  // namespace

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
  TemporaryPath temporary(path.parent_path(), path.filename().string() + ".", os::Open::replace);
  if (!temporary.file().is_open())
    throw Error(path.string(), fmt::format("cannot be written: {}", os::error_text(temporary.file().error())));
  int why = temporary.file().write(bytes);
  if (why == 0) why = temporary.file().sync();
  if (why != 0) throw Error(path.string(), fmt::format("writing failed: {}", os::error_text(why)));
  temporary.close();
  const auto lock = lock_temporary_paths();  // a signal either comes before the file is in place or after it
  std::error_code ec;
  fs::rename(temporary.path(), path, ec);
  if (ec) throw Error(path.string(), fmt::format("cannot be replaced: {}", ec.message()));
  sync_folder(path.parent_path());
}

void make_folder(const fs::path& path) {
  std::error_code ec;
  fs::create_directories(path, ec);
  if (ec) throw Error(path.string(), fmt::format("folder cannot be made: {}", ec.message()));
  if (!fs::is_directory(path, ec)) throw Error(path.string(), "is a file, a folder is needed");
}

}  // namespace taxel
