#include "core/base/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace taxel {
namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::error_code ec;
  if (!fs::exists(path, ec)) throw Error(path.string(), "no such file");
  if (fs::is_directory(path, ec)) throw Error(path.string(), "is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(path.string(), fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw Error(path.string(), "reading failed half way");
  return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  const fs::path beside = path.string() + fmt::format(".{}.part", ::getpid());
  std::error_code ec;
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    if (!out) throw Error(path.string(), fmt::format("cannot be written: {}", std::strerror(errno)));
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) {
      const int why = errno;
      out.close();
      fs::remove(beside, ec);
      throw Error(path.string(), fmt::format("writing failed: {}", std::strerror(why)));
    }
  }
  fs::rename(beside, path, ec);
  if (ec) {
    const std::string why = ec.message();
    fs::remove(beside, ec);
    throw Error(path.string(), fmt::format("cannot be replaced: {}", why));
  }
}

void make_folder(const fs::path& path) {
  std::error_code ec;
  fs::create_directories(path, ec);
  if (ec) throw Error(path.string(), fmt::format("folder cannot be made: {}", ec.message()));
  if (!fs::is_directory(path, ec)) throw Error(path.string(), "is a file, a folder is needed");
}

}  // namespace taxel
