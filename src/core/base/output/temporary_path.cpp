#include "core/base/output/temporary_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <random>
#include <system_error>

#include "core/base/error.h"
#include "core/base/os/process.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSuffix = ".part";
constexpr std::size_t kDigits = 8;  // hexadecimal digits of the number in a name

/// Paths to remove. The object is never destroyed: a thread may end the process while others run.
struct Registry {
  std::recursive_timed_mutex mutex;
  std::vector<fs::path> paths;
  std::vector<fs::path> folders;  ///< made folders, to be removed if they are empty
};
Registry& registry() {
  static auto* const only = new Registry;
  return *only;
}

void forget(std::vector<fs::path>& paths, const fs::path& path) {
  if (const auto found = std::find(paths.begin(), paths.end(), path); found != paths.end()) paths.erase(found);
}

/// Returns a new name, which differs from call to call and cannot be foreseen.
std::string new_name(const std::string& prefix) {
  static std::random_device numbers;
  return fmt::format("{}{}-{:0{}x}{}", prefix, os::process_id(), numbers(), kDigits, kSuffix);
}

/// The process id in `name`, or 0 if the name is none of new_name().
int process_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(kSuffix)) return 0;
  name.remove_prefix(prefix.size());
  if (name.size() <= kSuffix.size() + kDigits + 1) return 0;
  name.remove_suffix(kSuffix.size());
  const std::string_view number = name.substr(name.size() - kDigits);
  name.remove_suffix(kDigits);
  if (!name.ends_with('-') || number.find_first_not_of("0123456789abcdef") != std::string_view::npos) return 0;
  name.remove_suffix(1);
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

TemporaryPath::TemporaryPath(const fs::path& folder, const std::string& prefix, os::Open how) {
  const auto lock = lock_temporary_paths();
  remove_stale(folder, prefix);
  constexpr int kMostTries = 100;
  for (int i = 0; i < kMostTries && (i == 0 || os::is_taken(file_.error())); ++i) {
    path_ = folder / new_name(prefix);
    file_ = os::File(path_, how);
  }
  if (!file_.is_open()) return;
  static_cast<void>(file_.try_lock());  // if locks are not supported, stale paths are not removed
  registry().paths.push_back(path_);
}

TemporaryPath::~TemporaryPath() {
  const auto lock = lock_temporary_paths();
  std::error_code ec;
  if (file_.is_open() || std::count(registry().paths.begin(), registry().paths.end(), path_) > 0)
    fs::remove_all(path_, ec);
  forget(registry().paths, path_);
  close();
}

MadeFolders::~MadeFolders() {
  const auto lock = lock_temporary_paths();
  for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder) {
    os::remove_empty_folder(*folder);
    forget(registry().folders, *folder);
  }
}

void MadeFolders::make(const fs::path& folder) {
  const auto lock = lock_temporary_paths();
  const int why = os::create_folders(folder, [this](const fs::path& made) {
    folders_.push_back(made);
    registry().folders.push_back(made);
  });
  if (why != 0) throw Error(folder.string(), fmt::format("folder cannot be made: {}", os::error_text(why)));
  std::error_code ec;
  if (!fs::is_directory(folder, ec)) throw Error(folder.string(), "is a file, a folder is needed");
}

std::unique_lock<std::recursive_timed_mutex> lock_temporary_paths() {
  return std::unique_lock(registry().mutex);
}

void remove_temporary_paths() {
  // The lock stays: no thread creates another path before the process ends.
  if (!registry().mutex.try_lock_for(std::chrono::seconds(1))) return;
  std::error_code ec;
  for (const fs::path& path : registry().paths) fs::remove_all(path, ec);
  const std::vector<fs::path>& folders = registry().folders;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) os::remove_empty_folder(*folder);
}

}  // namespace taxel
