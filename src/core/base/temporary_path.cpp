#include "core/base/temporary_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

#include "core/base/os/process.h"

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
int process_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(kSuffix)) return 0;
  name.remove_prefix(prefix.size());
  if (name.size() <= kSuffix.size()) return 0;
  name.remove_suffix(kSuffix.size());
  int id = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), id);
  return error == std::errc() && end == name.data() + name.size() && id > 0 ? id : 0;
}

/// Returns true if the process that created `path` has ended. The id alone does not show it: the process may run on
/// another machine or in another container that shares the folder. A process that runs holds the lock.
bool is_stale(const fs::path& path, int process) {
  if (process != os::process_id() && os::has_process(process)) return false;
  const os::File file(path, os::Open::check);
  return file.is_open() && file.try_lock();
}

void remove_stale(const fs::path& folder, const std::string& prefix) {
  std::error_code ec;
  std::vector<fs::path> stale;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, ec), end; !ec && at != end; at.increment(ec)) {
    const int process = process_of(at->path().filename().string(), prefix);
    if (process > 0 && is_stale(at->path(), process)) stale.push_back(at->path());
  }
  for (const fs::path& path : stale) fs::remove_all(path, ec);
}

}  // namespace

TemporaryPath::TemporaryPath(const fs::path& folder, const std::string& prefix, os::Open how)
    : path_(folder / fmt::format("{}{}{}", prefix, os::process_id(), kSuffix)) {
  const auto lock = lock_temporary_paths();
  remove_stale(folder, prefix);
  file_ = os::File(path_, how);
  if (!file_.is_open()) return;
  static_cast<void>(file_.try_lock());  // if locks are not supported, stale paths are not removed
  registry().paths.push_back(path_);
}

TemporaryPath::~TemporaryPath() {
  const auto lock = lock_temporary_paths();
  std::error_code ec;
  if (file_.is_open() || std::count(registry().paths.begin(), registry().paths.end(), path_) > 0)
    fs::remove_all(path_, ec);
  forget(path_);
  close();
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
