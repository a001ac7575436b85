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
#include "core/base/temporary_path.h"

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
  /// Appends the next bytes of the file. Returns false at the end of the file or after an error; after an error errno
  /// is not 0.
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

 private:
  int number_;
};

/// Waits until all written bytes are on the disk. Returns 0 or the error number.
int sync(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: the descriptor has no disk behind it
}

/// Writes all bytes and waits until they are on the disk. Returns 0 or the error number.
int write_bytes(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return sync(descriptor);
}

void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  sync(descriptor);  // the new file is in place: there is nothing to take back if this fails
  ::close(descriptor);
}

}  // namespace

std::string read_file(const fs::path& path, std::uint64_t max_bytes) {
  const auto too_large = [&] {
    return Error(path.string(), fmt::format("is larger than {} bytes, the most that is read", max_bytes));
  };
  const auto unreadable = [&] { return Error(path.string(), fmt::format("cannot be read: {}", std::strerror(errno))); };
  const Descriptor in(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);  // O_NONBLOCK: opening a FIFO would wait for a writer
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
  int why = 0;
  TemporaryPath temporary(path.parent_path(), path.filename().string() + ".", [&](const fs::path& at) {
    const int descriptor = ::open(at.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    why = descriptor < 0 ? errno : 0;
    return descriptor;
  });
  if (why != 0) throw Error(path.string(), fmt::format("cannot be written: {}", std::strerror(why)));
  why = write_bytes(temporary.descriptor(), bytes);
  if (why != 0) throw Error(path.string(), fmt::format("writing failed: {}", std::strerror(why)));
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
