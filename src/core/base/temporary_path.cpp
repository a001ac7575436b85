#include "core/base/temporary_path.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <system_error>
#include <utility>
#include <vector>

namespace taxel {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSuffix = ".part";

/// Paths to remove. The object is never destroyed: a thread may end the process while others run.
struct Registry {
  std::recursive_mutex mutex;
  std::vector<fs::path> paths;
};
Registry& registry() {
  static auto* const only = new Registry;
  return *only;
}

void forget(const fs::path& path) {
  std::vector<fs::path>& paths = registry().paths;
  if (const auto found = std::find(paths.begin(), paths.end(), path); found != paths.end()) paths.erase(found);
}

/// The process id in `name`, or 0 if the name is not PREFIX + id + ".part".
pid_t process_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(kSuffix)) return 0;
  name.remove_prefix(prefix.size());
  if (name.size() <= kSuffix.size()) return 0;
  name.remove_suffix(kSuffix.size());
  pid_t id = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), id);
  return error == std::errc() && end == name.data() + name.size() && id > 0 ? id : 0;
}

/// Returns true if the process that created `path` has ended. The id alone does not show it: the process may run on
/// another machine or in another container that shares the folder. A process that runs holds the lock.
bool is_stale(const fs::path& path, pid_t process) {
  const bool runs = process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH);
  if (runs) return false;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return is_free;
}

void remove_stale(const fs::path& folder, const std::string& prefix) {
  std::error_code ec;
  std::vector<fs::path> stale;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, ec), end; !ec && at != end; at.increment(ec)) {
    const pid_t process = process_of(at->path().filename().string(), prefix);
    if (process > 0 && is_stale(at->path(), process)) stale.push_back(at->path());
  }
  for (const fs::path& path : stale) fs::remove_all(path, ec);
}

}  // namespace

TemporaryPath::TemporaryPath(const fs::path& folder, const std::string& prefix,
                             const std::function<int(const fs::path&)>& create)
    : path_(folder / fmt::format("{}{}{}", prefix, ::getpid(), kSuffix)) {
  const auto lock = lock_temporary_paths();
  remove_stale(folder, prefix);
  descriptor_ = create(path_);
  if (descriptor_ < 0) return;
  ::flock(descriptor_,
          LOCK_EX | LOCK_NB);  // if locks are not supported, stale paths are not removed
  registry().paths.push_back(path_);
}

TemporaryPath::~TemporaryPath() {
  const auto lock = lock_temporary_paths();
  std::error_code ec;
  if (descriptor_ >= 0 || std::count(registry().paths.begin(), registry().paths.end(), path_) > 0)
    fs::remove_all(path_, ec);
  forget(path_);
  close();
}

void TemporaryPath::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

UnfinishedFolder::UnfinishedFolder(fs::path folder) : folder_(std::move(folder)) {
  const auto lock = lock_temporary_paths();
  if (!folder_.empty()) registry().paths.push_back(folder_);
}

UnfinishedFolder::~UnfinishedFolder() {
  const auto lock = lock_temporary_paths();
  std::error_code ec;
  if (!folder_.empty()) fs::remove_all(folder_, ec);
  forget(folder_);
}

void UnfinishedFolder::keep() {
  const auto lock = lock_temporary_paths();
  forget(folder_);
  folder_.clear();
}

std::unique_lock<std::recursive_mutex> lock_temporary_paths() {
  return std::unique_lock(registry().mutex);
}

void remove_temporary_paths() {
  registry().mutex.lock();  // stays locked: no thread creates another path before the process ends
  std::error_code ec;
  for (const fs::path& path : registry().paths) fs::remove_all(path, ec);
}

}  // namespace taxel
