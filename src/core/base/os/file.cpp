#include "core/base/os/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace taxel::os {
namespace {

constexpr unsigned kEverybody = 0666, kOnlyUser = 0600, kFolder = 0777;  // rights of new files, before the umask

struct Flags {
  int flags;
  unsigned rights;
};

Flags flags_of(Open how) {
  switch (how) {
    case Open::read:
      return {O_RDONLY | O_NONBLOCK | O_NOCTTY, 0};
    case Open::replace:
      return {O_WRONLY | O_CREAT | O_TRUNC, kEverybody};
    case Open::append:
      return {O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK, kOnlyUser};
    case Open::hold:
      return {O_RDWR | O_CREAT, kOnlyUser};
    case Open::check:
      return {O_RDONLY | O_NOFOLLOW | O_NONBLOCK, 0};
    case Open::folder:
    case Open::create_folder:
      break;
  }
  return {O_RDONLY | O_DIRECTORY, 0};
}

}  // namespace

File::File(const std::filesystem::path& path, Open how) {
  if (how == Open::create_folder && ::mkdir(path.c_str(), kFolder) != 0) {
    error_ = errno;
    return;
  }
  const Flags f = flags_of(how);
  number_ = ::open(path.c_str(), f.flags | O_CLOEXEC, f.rights);
  if (number_ < 0) error_ = errno;
}

File::File(File&& other) noexcept : number_(std::exchange(other.number_, -1)), error_(std::exchange(other.error_, 0)) {}

File& File::operator=(File&& other) noexcept {
  if (this == &other) return *this;
  close();
  number_ = std::exchange(other.number_, -1);
  error_ = std::exchange(other.error_, 0);
  return *this;
}

void File::close() {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

bool File::try_lock() const {
  return ::flock(number_, LOCK_EX | LOCK_NB) == 0;
}

Kind File::kind() const {
  struct stat status {};
  if (::fstat(number_, &status) != 0) return Kind::unknown;
  return S_ISREG(status.st_mode) ? Kind::file : S_ISDIR(status.st_mode) ? Kind::folder : Kind::other;
}

std::uint64_t File::size() const {
  struct stat status {};
  return ::fstat(number_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

int File::read_all(std::string& bytes, std::uint64_t max_bytes) const {
  std::array<char, 1U << 16> block;
  while (bytes.size() <= max_bytes) {
    const ssize_t n = ::read(number_, block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) return 0;
    bytes.append(block.data(), static_cast<std::size_t>(n));
  }
  return 0;
}

int File::read_at(std::string& bytes, std::uint64_t offset, std::size_t size) const {
  bytes.resize(size);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::pread(number_, bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return 0;
}

int File::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(number_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int File::write_at_once(std::string_view bytes) const {
  errno = 0;
  if (::write(number_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size())) return 0;
  return errno != 0 ? errno : ENOSPC;  // a part was written: the disk is full
}

int File::clear() const {
  return ::ftruncate(number_, 0) == 0 ? 0 : errno;
}

int File::sync() const {
  return ::fsync(number_) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: there is no disk behind it
}

std::string error_text(int error) {
  return std::strerror(error);
}

bool is_missing(int error) {
  return error == ENOENT || error == ENOTDIR;
}

bool has_no_file(int error) {
  return error == ENXIO;
}

}  // namespace taxel::os
