#include "app/studio/host/document/autosave.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/studio/host/document/project_files.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/process.h"

namespace taxel::studio {

namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& file, const char* extension) {
  fs::path other = file;
  return other.replace_extension(extension);
}

void remove_kept(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
  fs::remove(beside(file, ".origin"), ignored);
}

/// Returns the locked file, or a closed one if another process has locked it.
os::File try_lock(const fs::path& file) {
  os::File lock(file, os::Open::hold);
  if (lock.is_open() && !lock.try_lock()) lock.close();
  return lock;
}

std::string local_time(const fs::path& file) {
  std::error_code ignored;
  const auto written = std::chrono::file_clock::to_sys(fs::last_write_time(file, ignored));
  return fmt::format("{:%Y-%m-%d %H:%M:%S}",
                     fmt::localtime(std::chrono::system_clock::to_time_t(
                         std::chrono::time_point_cast<std::chrono::system_clock::duration>(written))));
}

/// Two lines: the document's name, and the file that it came from.
std::pair<std::string, std::string> read_origin(const fs::path& file) {
  try {
    const std::string text = read_file(file);
    const std::size_t end = text.find('\n');
    std::string origin = end == std::string::npos ? "" : text.substr(end + 1);
    while (!origin.empty() && origin.back() == '\n') origin.pop_back();
    return {text.substr(0, end), origin};
  } catch (const Error&) {
    return {"A document", ""};
  }
}

}  // namespace

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Autosave::Autosave(JobExecutor& executor, double every_seconds)
    : every_(every_seconds),
      slot_(executor, Priority::background,
            [this](const std::shared_ptr<const Task>& task, Outcome&, Progress&) { carry_out(*task); }) {}

Autosave::~Autosave() {
  stop();
}

void Autosave::end() {
  if (!started()) return;
  stop();
  forget({file_, "", "", ""});
}

/// Drops a task that has not begun and waits for a running one.
void Autosave::stop() {
  if (!started()) return;
  slot_.post(std::nullopt);
  slot_.wait();
  lock_.close();
}

void Autosave::start(const fs::path& folder) {
  make_folder(folder);
  folder_ = folder;
  for (int number = 1; !lock_.is_open(); ++number) {
    file_ = folder / fmt::format("{}-{}.taxelproj", os::process_id(), number);
    std::error_code ignored;
    if (fs::exists(file_, ignored)) continue;  // left behind by another one of this number
    lock_ = try_lock(beside(file_, ".lock"));
    constexpr int kMostTries = 1000;
    if (!lock_.is_open() && number == kMostTries) throw Error(folder.string(), "cannot be written: edits are not kept");
  }
}

std::string Autosave::update(const ProjectPtr& unsaved, std::uint64_t revision, const std::string& name,
                             const std::string& origin, double now) {
  if (!started()) return {};
  const std::string failure = new_failure();
  if (!unsaved) {
    unkept_since_.reset();
    kept_ = 0;
    if (std::exchange(sent_, false)) send({});
  } else if (taken_over_) {
    kept_ = revision;
    sent_ = true;
    send({unsaved, name, origin, std::exchange(taken_over_, std::nullopt)});
  } else if (revision == kept_) {
    unkept_since_.reset();
  } else if (!unkept_since_) {
    unkept_since_ = now;
  } else if (now - *unkept_since_ >= every_) {
    unkept_since_.reset();
    kept_ = revision;
    sent_ = true;
    send({unsaved, name, origin, std::nullopt});
  }
  return failure;
}

std::string Autosave::new_failure() {
  const auto outcome = slot_.take();
  if (!outcome) return {};
  if (!outcome->problem.empty()) kept_ = 0;  // written again
  return std::exchange(reported_, outcome->problem) == outcome->problem ? "" : outcome->problem;
}

std::optional<double> Autosave::seconds_until_due(double now) const {
  if (!started() || !unkept_since_) return std::nullopt;
  return std::max(0.0, *unkept_since_ + every_ - now);
}

void Autosave::leave(const ProjectPtr& unsaved, const std::string& name, const std::string& origin) {
  if (!started()) return;
  if (!unsaved) return end();
  const Task last = completed({unsaved, name, origin, taken_over_});
  slot_.post(std::nullopt);
  slot_.wait();
  try {
    carry_out(last);
  } catch (const std::exception&) {  // the file that was written last remains
  }
  stop();
}

/// Adds the document that the task to be replaced would forget.
Autosave::Task Autosave::completed(Task task) const {
  const auto replaced = slot_.posted();
  if (replaced && !task.forget) task.forget = (*replaced)->forget;
  return task;
}

void Autosave::carry_out(const Task& task) const {
  if (task.project) {
    write_file_atomically(beside(file_, ".origin"), task.name + "\n" + task.origin + "\n");
    write_project(file_, with_mesh_on_disk(*task.project, file_));
  } else {
    remove_kept(file_);
  }
  if (task.forget) forget(*task.forget);
}

std::vector<LostDocument> Autosave::lost() const {
  std::vector<LostDocument> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const fs::path file = entry.path();
    if (file.extension() != ".taxelproj" || file == file_ || !fs::is_regular_file(file, error)) continue;
    if (!try_lock(beside(file, ".lock")).is_open()) continue;  // its program lives
    const auto [name, origin] = read_origin(beside(file, ".origin"));
    found.push_back({file, name, origin, local_time(file)});
  }
  std::sort(found.begin(), found.end(), [](const LostDocument& a, const LostDocument& b) { return a.when > b.when; });
  return found;
}

void Autosave::forget(const LostDocument& lost) {
  remove_kept(lost.file);
  std::error_code ignored;
  fs::remove(beside(lost.file, ".lock"), ignored);
}

}  // namespace taxel::studio
