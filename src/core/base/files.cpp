#include "core/base/files.h"

#include <fcntl.h>
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

namespace {

/// A descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (open()) ::close(number_);
  }
  [[nodiscard]] bool open() const { return number_ >= 0; }
  /// All bytes, and down to the disk. False: errno says why.
  [[nodiscard]] bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(number_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) return false;
      if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return sync();
  }
  [[nodiscard]] bool sync() const { return ::fsync(number_) == 0 || errno == EINVAL; }  // EINVAL: has no disk

 private:
  int number_;
};

void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
  // The new file is in place: where its folder cannot be synced there is nothing to take back.
  static_cast<void>(descriptor.open() && descriptor.sync());
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  const fs::path beside = path.string() + fmt::format(".{}.part", ::getpid());
  std::error_code ec;
  {
    const Descriptor out(beside, O_WRONLY | O_CREAT | O_TRUNC);
    if (!out.open()) throw Error(path.string(), fmt::format("cannot be written: {}", std::strerror(errno)));
    if (!out.write(bytes)) {
      const int why = errno;
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
  sync_folder(path.parent_path());
}

void make_folder(const fs::path& path) {
  std::error_code ec;
  fs::create_directories(path, ec);
  if (ec) throw Error(path.string(), fmt::format("folder cannot be made: {}", ec.message()));
  if (!fs::is_directory(path, ec)) throw Error(path.string(), "is a file, a folder is needed");
}

}  // namespace taxel
