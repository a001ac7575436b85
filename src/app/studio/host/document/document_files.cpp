#include "app/studio/host/document/document_files.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <system_error>
#include <utility>

#include "app/studio/host/document/documents.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/process.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/sensor/sensor_cache.h"

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
                             const std::string& origin, double now, const OpenMeshPtr& mesh) {
  if (!started()) return {};
  const std::string failure = new_failure();
  if (!unsaved) {
    unkept_since_.reset();
    kept_ = 0;
    if (std::exchange(sent_, false)) send({});
  } else if (taken_over_) {
    kept_ = revision;
    sent_ = true;
    send({unsaved, name, origin, std::exchange(taken_over_, std::nullopt), mesh});
  } else if (revision == kept_) {
    unkept_since_.reset();
  } else if (!unkept_since_) {
    unkept_since_ = now;
  } else if (now - *unkept_since_ >= every_) {
    unkept_since_.reset();
    kept_ = revision;
    sent_ = true;
    send({unsaved, name, origin, std::nullopt, mesh});
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

void Autosave::leave(const ProjectPtr& unsaved, const std::string& name, const std::string& origin,
                     const OpenMeshPtr& mesh) {
  if (!started()) return;
  if (!unsaved) return end();
  const Task last = completed({unsaved, name, origin, taken_over_, mesh});
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
    write_project(file_, with_mesh_on_disk(*task.project, file_, task.mesh));
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

namespace {

constexpr double kBetweenLooks = 0.5;  // [s]

}  // namespace

std::string hash_of(const std::string& file) {
  try {
    return file.empty() ? "" : sha256_hex(read_file(file));
  } catch (const Error&) {
    return "";
  }
}

FileWatch::Stamp FileWatch::stamp_of(const std::string& file) {
  std::error_code missing;
  Stamp stamp;
  stamp.time = std::filesystem::last_write_time(file, missing);
  if (missing) return {};
  stamp.size = std::filesystem::file_size(file, missing);
  if (missing) return {};
  stamp.exists = true;
  return stamp;
}

void FileWatch::watch(const std::vector<std::string>& files) {
  const auto same = [](const Watched& one, const std::string& file) { return one.file == file; };
  if (std::equal(watched_.begin(), watched_.end(), files.begin(), files.end(), same)) return;
  std::vector<Watched> watched;
  for (const std::string& file : files) {
    const auto found =
        std::find_if(watched_.begin(), watched_.end(), [&](const Watched& one) { return same(one, file); });
    const Stamp stamp = found == watched_.end() ? stamp_of(file) : Stamp{};
    watched.push_back(found == watched_.end() ? Watched{file, stamp, stamp} : *found);
  }
  watched_ = std::move(watched);
}

void FileWatch::accept(const std::string& file) {
  for (Watched& watched : watched_) {
    if (watched.file == file) watched.accepted = watched.last = stamp_of(file);
  }
}

std::vector<std::pair<std::string, FileChange>> FileWatch::look(double now) {
  std::vector<std::pair<std::string, FileChange>> changes;
  if (now < next_) return changes;
  next_ = now + kBetweenLooks;
  for (Watched& watched : watched_) {
    const Stamp stamp = stamp_of(watched.file);
    const bool still = stamp == watched.last;
    watched.last = stamp;
    if (!still || stamp == watched.accepted) continue;
    watched.accepted = stamp;
    changes.emplace_back(watched.file, stamp.exists ? FileChange::changed : FileChange::deleted);
  }
  return changes;
}

ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout) {
  const SensorSkinPtr skin = make_sensor_skin(mesh->loaded.mesh, layout.sampling.shells);
  return {ref, mesh, skin->sensed, distances_to(*skin->sensed, layout), ""};
}

MeshComparison::MeshComparison(JobExecutor& executor)
    : slot_(executor, Priority::normal,
            [](const std::shared_ptr<const Layout>& layout, ComparedMesh& out, Progress& progress) {
              out.ref = layout->mesh;
              const OpenMeshPtr mesh = read_open_mesh(layout->mesh, &progress);
              MeshRef ref = layout->mesh;
              ref.sha256 = mesh->loaded.sha256;
              out = compare_mesh(ref, mesh, *layout);
            }) {}

void MeshComparison::start(const Layout& layout) {
  slot_.post(std::nullopt, Superseded::cancel);
  slot_.post(std::make_shared<const Layout>(layout));
}

std::optional<ComparedMesh> MeshComparison::take() {
  const auto compared = slot_.take();
  return compared ? std::optional(*compared) : std::nullopt;
}

namespace {

bool holds(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) == bytes.size() && read_file(file) == bytes;
}

/// Writes a mesh into a folder, as the first of "fingertip.obj", "fingertip-1.obj", ... that does not exist or holds
/// this mesh already. Returns its path.
std::string written_to(const fs::path& folder, const fs::path& name, std::string_view bytes) {
  fs::path file = folder / name;
  std::error_code ignored;
  for (int number = 1; fs::exists(file, ignored) && !holds(file, bytes); ++number)
    file = folder / fmt::format("{}-{}{}", name.stem().string(), number, name.extension().string());
  if (!holds(file, bytes)) write_file_atomically(file, bytes);
  return file.string();
}

/// Returns the letters and digits of a name, with one dash in place of the characters between them; "layout" if there
/// are none.
std::string file_name_of(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      text += c;
    } else if (!text.empty() && text.back() != '-') {
      text += '-';
    }
  }
  while (!text.empty() && text.back() == '-') text.pop_back();
  return text.empty() ? "layout" : text;
}

}  // namespace

Project with_mesh_on_disk(Project project, const fs::path& file, const OpenMeshPtr& mesh) {
  const fs::path folder = fs::absolute(file).parent_path();
  const BuiltInMesh built_in = built_in_mesh();
  MeshRef& ref = project.layout.mesh;
  std::error_code ignored;
  if (ref.file == built_in.name) {
    ref.file = written_to(folder, built_in.name, built_in.bytes);
  } else if (mesh && !fs::exists(ref.file, ignored)) {
    const std::string bytes = write_obj(*mesh->loaded.mesh);
    ref = {written_to(folder, fs::path(ref.file).stem().string() + ".obj", bytes), dvec3(1.0), sha256_hex(bytes)};
  }
  return project;
}

SuggestedFile suggested_file(const std::string& file, const std::string& name, const std::string& extension) {
  SuggestedFile suggested;
  std::string stem = file_name_of(name);
  if (!file.empty()) {
    const fs::path path = fs::absolute(file);
    suggested.folder = path.parent_path().string();
    const std::string whole = path.filename().string();
    stem = whole.substr(0, whole.find('.', 1));
  }
  suggested.name = stem + extension;
  return suggested;
}

}  // namespace taxel::studio
