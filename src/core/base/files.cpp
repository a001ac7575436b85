#include "core/base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/base/error.h"

namespace taxel {
namespace fs = std::filesystem;

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
  /// Appends the next bytes of the file. False at the end of the file, or after an error; then errno is not 0.
  [[nodiscard]] bool read(std::string& bytes) const {
    std::array<char, 1U << 16> block;
    errno = 0;
    ssize_t n = 0;
    do n = ::read(number_, block.data(), block.size());
    while (n < 0 && errno == EINTR);
    if (n > 0) bytes.append(block.data(), static_cast<std::size_t>(n));
    return n > 0;
  }
  [[nodiscard]] bool status(struct stat& out) const { return ::fstat(number_, &out) == 0; }
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

std::string read_file(const fs::path& path, std::uint64_t max_bytes) {
  const auto too_large = [&] {
    return Error(path.string(), fmt::format("is larger than {} bytes, the most that is read", max_bytes));
  };
  const auto unreadable = [&] { return Error(path.string(), fmt::format("cannot be read: {}", std::strerror(errno))); };
  const Descriptor in(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);  // without O_NONBLOCK opening a FIFO waits for a writer
  struct stat status {};
  if (!in.open() && (errno == ENOENT || errno == ENOTDIR)) throw Error(path.string(), "no such file");
  if (!in.open() && errno == ENXIO) throw Error(path.string(), "is not a regular file");  // a socket
  if (!in.open() || !in.status(status)) throw unreadable();
  if (S_ISDIR(status.st_mode)) throw Error(path.string(), "is a folder, not a file");
  if (!S_ISREG(status.st_mode)) throw Error(path.string(), "is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) throw too_large();
  std::string bytes;
  bytes.reserve(size + 1);
  while (in.read(bytes))
    if (bytes.size() > max_bytes) throw too_large();
  if (errno != 0) throw unreadable();
  return bytes;
}

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
