// Files by the calls of POSIX and Linux, and the folders of the user.

#include "core/base/os/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace taxel::os {
namespace {

constexpr unsigned kEverybody = 0666, kOnlyUser = 0600;  // rights of new files, before the umask
constexpr unsigned kFolder = 0777, kPrivateFolder = 0700, kRights = 07777;

struct Flags {
  int flags;
  unsigned rights;
};

Flags flags_of(Open how) {
  switch (how) {
    case Open::read:
      return {O_RDONLY | O_NONBLOCK | O_NOCTTY, 0};
    case Open::create:
      return {O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, kEverybody};
    case Open::create_private:
      return {O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, kOnlyUser};
    case Open::write:
      return {O_WRONLY | O_NONBLOCK | O_NOCTTY, 0};
    case Open::append:
      return {O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK, kOnlyUser};
    case Open::hold:
      return {O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK, kOnlyUser};
    case Open::check:
      return {O_RDONLY | O_NOFOLLOW | O_NONBLOCK, 0};
    case Open::folder:
      return {O_RDONLY | O_DIRECTORY, 0};
    case Open::create_folder:
      break;
  }
  return {O_RDONLY | O_DIRECTORY | O_NOFOLLOW, 0};
}

Status status_from(const struct stat& status) {
  const Kind kind = S_ISREG(status.st_mode)   ? Kind::file
                    : S_ISDIR(status.st_mode) ? Kind::folder
                    : S_ISBLK(status.st_mode) ? Kind::disk
                                              : Kind::other;
  return {kind,
          static_cast<unsigned>(status.st_mode) & kRights,
          status.st_uid,
          status.st_gid,
          status.st_nlink,
          status.st_dev,
          status.st_ino};
}

}  // namespace

File::File(const std::filesystem::path& path, Open how) {
  if (how == Open::create_folder && ::mkdir(path.c_str(), kPrivateFolder) != 0) {
    error_ = errno;
    return;
  }
  const Flags f = flags_of(how);
  number_ = ::open(path.c_str(), f.flags | O_CLOEXEC, f.rights);
  if (number_ < 0) error_ = errno;
  if (how == Open::write && is_open()) ::fcntl(number_, F_SETFL, ::fcntl(number_, F_GETFL) & ~O_NONBLOCK);
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
  return ::fstat(number_, &status) == 0 ? status_from(status).kind : Kind::unknown;
}

bool File::take_rights(const Status& from) const {
  struct stat own {};
  if (::fstat(number_, &own) != 0) return false;
  const bool is_owned = own.st_uid == from.owner && own.st_gid == from.group;
  return (is_owned || ::fchown(number_, from.owner, from.group) == 0) && ::fchmod(number_, from.rights) == 0;
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

int File::cut(std::uint64_t size) const {
  return ::ftruncate(number_, static_cast<off_t>(size)) == 0 ? 0 : errno;
}

int File::reserve(std::uint64_t size) const {
  const int why = size > 0 ? ::posix_fallocate(number_, 0, static_cast<off_t>(size)) : 0;
  return why == EOPNOTSUPP || why == EINVAL ? 0 : why;
}

int File::sync() const {
  return ::fsync(number_) == 0 || errno == EINVAL ? 0 : errno;  // EINVAL: there is no disk behind it
}

int look_at(const std::filesystem::path& path, Status& out) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return errno;
  out = status_from(status);
  return 0;
}

bool can_write(const std::filesystem::path& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

bool has_access_list(const std::filesystem::path& path) {
  return ::getxattr(path.c_str(), "system.posix_acl_access", nullptr, 0) > 0;
}

File standard_output_of(const Status& status) {
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(number, &own) == 0 && own.st_dev == status.device && own.st_ino == status.inode)
      return File::of_number(::fcntl(number, F_DUPFD_CLOEXEC, 0));
  }
  return {};
}

int create_folders(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path&)>& on_made) {
  constexpr int kMostTries = 1000;  // another process may remove a parent at the moment when this one enters it
  int why = 0;
  for (int i = 0; i < kMostTries; ++i) {
    why = ::mkdir(path.c_str(), kFolder) == 0 ? 0 : errno;
    if (why == 0 && on_made) on_made(path);
    Status status;
    const int missing = why == 0 ? 0 : look_at(path, status);
    if (missing == 0) return 0;
    const std::filesystem::path parent = path.parent_path();
    if (!is_missing(missing) || parent.empty() || parent == path) return why;
    if (const int failed = create_folders(parent, on_made); failed != 0) return failed;
    if (look_at(parent, status) == 0 && status.kind != Kind::folder) return why;
  }
  return why;
}

void remove_empty_folder(const std::filesystem::path& path) {
  static_cast<void>(::rmdir(path.c_str()));
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

bool is_taken(int error) {
  return error == EEXIST;
}

namespace {

std::filesystem::path folder_of(const char* variable, const char* below_home) {
  const char* set = std::getenv(variable);
  if (set != nullptr && *set != '\0') return set;
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / below_home;
}

}  // namespace

std::filesystem::path config_folder() {
  return folder_of("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path state_folder() {
  return folder_of("XDG_STATE_HOME", ".local/state");
}

std::filesystem::path cache_folder() {
  return folder_of("XDG_CACHE_HOME", ".cache");
}

}  // namespace taxel::os
