// Unfinished paths with their registry, files that are written, and folders that are filled as a whole.

#include "core/base/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <random>
#include <set>
#include <string>
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

namespace {

/// Returns the path behind all links. It may not exist.
fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;  // as in Linux
  std::error_code ec;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, ec)); ++i) {
    const fs::path next = fs::read_symlink(path, ec);
    if (ec) break;
    path = path.parent_path() / next;
  }
  return path;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool is_same(const os::Status& a, const os::Status& b) {
  return a.device == b.device && a.inode == b.inode;
}

void sync_folder(const fs::path& folder) {
  const os::File file(folder, os::Open::folder);
  if (file.is_open()) static_cast<void>(file.sync());  // the new file is in place: a failure changes nothing
}

/// Passes the content of a file to `use`, piece by piece, until it returns an error.
template <class Use>
int each_piece(const fs::path& path, const Use& use) {
  constexpr std::size_t kPieceBytes = std::size_t{1} << 20;
  const os::File in(path, os::Open::check);
  if (!in.is_open()) return in.error();
  std::string piece;
  for (std::uint64_t at = 0;; at += piece.size()) {
    if (const int why = in.read_at(piece, at, kPieceBytes); why != 0) return why;
    if (piece.empty()) return 0;
    if (const int why = use(piece); why != 0) return why;
  }
}

}  // namespace

TargetFile::TargetFile(const fs::path& path) : path_(path), real_(path) {
  const auto refuse = [&](const std::string& why) { throw Error(path_.string(), why); };
  if (const int why = os::look_at(path_, old_); why != 0) {
    if (!os::is_missing(why)) refuse("cannot be written: " + os::error_text(why));
    real_ = behind_links(path_);
    return;
  }
  exists_ = true;
  if (old_.kind == os::Kind::folder) refuse("is a folder, a file is needed");
  if (old_.kind == os::Kind::disk) refuse("is a disk, a file is needed");
  stream_ = os::standard_output_of(old_);
  real_ = behind_links(path_);
  os::Status behind;
  const bool has_name = os::look_at(real_, behind) == 0 && is_same(behind, old_);  // not so: /proc/self/fd/3
  if (stream_.is_open() || old_.kind != os::Kind::file || !has_name) {
    how_ = How::written_into;
    if (!stream_.is_open()) stream_ = os::File(path_, os::Open::write);
    if (os::has_no_file(stream_.error())) refuse("cannot be written: no program reads it");
    if (!stream_.is_open()) refuse("cannot be written: " + os::error_text(stream_.error()));
    return;
  }
  if (!os::can_write(real_)) refuse("cannot be written: the file is write-protected");
  if (old_.links > 1 || os::has_access_list(real_)) how_ = How::overwritten;
}

void TargetFile::fail(int why) const {
  throw Error(path_.string(), "writing failed: " + os::error_text(why));
}

template <class Content>
void TargetFile::write_content(const Content& content) const {
  if (how_ == How::written_into) {
    if (const int why = content(stream_); why != 0) fail(why);
    return;
  }
  TemporaryPath temporary(folder_of(real_), real_.filename().string() + ".",
                          exists_ ? os::Open::create_private : os::Open::create);
  if (!temporary.file().is_open())
    throw Error(path_.string(), "cannot be written: " + os::error_text(temporary.file().error()));
  int why = content(temporary.file());
  if (why == 0) why = temporary.file().sync();
  if (why != 0) fail(why);
  put_in_place(temporary.path(), temporary.file());
}

void TargetFile::write(std::string_view bytes) const {
  write_content([&](const os::File& out) { return out.write(bytes); });
}

void TargetFile::take(const fs::path& complete) const {
  os::Status from, folder;
  const bool can_move = how_ != How::written_into && os::look_at(complete, from) == 0 &&
                        os::look_at(folder_of(real_), folder) == 0 && from.device == folder.device;
  if (can_move) {
    const os::File file(complete, os::Open::check);
    if (!file.is_open()) fail(file.error());
    if (const int why = file.sync(); why != 0) fail(why);
    return put_in_place(complete, file);
  }
  write_content([&](const os::File& out) {
    return each_piece(complete, [&](const std::string& piece) { return out.write(piece); });
  });
}

void TargetFile::put_in_place(const fs::path& complete, const os::File& file) const {
  const auto lock = lock_temporary_paths();  // a signal either comes before the file is in place or after it
  if (how_ == How::overwritten || (exists_ && !file.take_rights(old_))) return overwrite(complete);
  std::error_code ec;
  fs::rename(complete, real_, ec);
  if (ec) throw Error(path_.string(), fmt::format("cannot be replaced: {}", ec.message()));
  sync_folder(folder_of(real_));
}

void TargetFile::overwrite(const fs::path& complete) const {
  const os::File out(real_, os::Open::write);
  if (!out.is_open()) fail(out.error());
  const std::uint64_t before = out.size();
  std::error_code ec;
  const std::uint64_t size = fs::file_size(complete, ec);
  if (ec) fail(ec.value());
  if (const int why = out.reserve(size); why != 0) {
    static_cast<void>(out.cut(before));
    fail(why);
  }
  int why = each_piece(complete, [&](const std::string& piece) { return out.write(piece); });
  if (why == 0) why = out.cut(size);
  if (why == 0) why = out.sync();
  if (why != 0) fail(why);
}

OutputFolder::OutputFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  constexpr int kMostTries = 100;  // another process may remove an empty parent that it has made
  int why = 0;
  for (int i = 0; i < kMostTries && (i == 0 || os::is_missing(why)); ++i) {
    try {
      made_.make(folder_);
    } catch (const Error& e) {
      throw Error(folder.string(), e.message());
    }
    staging_ = std::make_unique<TemporaryPath>(folder_, ".taxel-", os::Open::create_folder);
    why = staging_->file().error();
  }
  if (why != 0) throw Error(folder.string(), fmt::format("cannot be written: {}", os::error_text(why)));
}

OutputFolder::~OutputFolder() = default;

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  fill([&](const fs::path& folder) { TargetFile(folder / name).write(bytes); });
}

void OutputFolder::fill(const std::function<void(const fs::path&)>& fill) {
  const std::string staging = staging_->path().string();
  try {
    fill(staging_->path());
  } catch (const Error& e) {
    if (!e.file().starts_with(staging)) throw;
    throw Error(folder_.string() + e.file().substr(staging.size()), e.where(), e.message());
  }
}

void OutputFolder::discard() {
  std::error_code ec;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_->path(), ec))
    fs::remove_all(entry.path(), ec);
}

std::vector<fs::path> OutputFolder::collected() const {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(staging_->path()))
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(staging_->path()));
  std::sort(files.begin(), files.end());
  return files;
}

void OutputFolder::check_targets(const std::vector<fs::path>& files) const {
  std::error_code ec;
  const auto refuse = [&](const fs::path& name, const char* why) {
    throw Error((folder_ / name).string(), fmt::format("{}; no file was written", why));
  };
  for (const fs::path& file : files) {
    if (fs::is_directory(folder_ / file, ec)) refuse(file, "is a folder, a file is needed");
    for (fs::path above = file.parent_path(); !above.empty(); above = above.parent_path())
      if (fs::exists(folder_ / above, ec) && !fs::is_directory(folder_ / above, ec))
        refuse(above, "is a file, a folder is needed");
  }
  for (const std::string& name : left_out_)
    if (fs::is_directory(folder_ / name, ec)) refuse(name, "is a folder, a file of this name would be removed");
}

std::vector<std::string> OutputFolder::commit() {
  const auto lock = lock_temporary_paths();  // a signal waits until all files are in place
  const std::vector<fs::path> files = collected();
  check_targets(files);
  std::vector<TargetFile> targets;
  for (const fs::path& file : files) targets.emplace_back(folder_ / file);
  std::set<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    made_.make((folder_ / files[i]).parent_path());
    targets[i].take(staging_->path() / files[i]);
    names.insert(files[i].begin()->string());
  }
  for (const std::string& name : left_out_) {
    std::error_code ec;
    fs::remove(folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be removed: {}", ec.message()));
  }
  left_out_.clear();
  return {names.begin(), names.end()};
}

}  // namespace taxel
