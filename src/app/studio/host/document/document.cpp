#include "app/studio/host/document/document.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/examples.h"
#include "core/base/error.h"
#include "core/base/text/message.h"

namespace taxel::studio {

Loader::Loader(JobExecutor& executor, SensorCache& cache)
    : slot_(executor, Priority::background,
            [&cache](const std::shared_ptr<const Task>& task, LoadResult& out, Progress& progress) {
              run(*task, cache, out, progress);
            }) {}

void Loader::run(const Task& task, SensorCache& cache, LoadResult& out, Progress& progress) {
  SensorBuild how(&progress);
  how.cache = &cache;
  try {
    if (task.document) {
      out = Polished{task.document->model, task.document->compile(how)};
    } else {
      how.quality = SampleQuality::preview;
      out = is_built_in(task.file) ? load_built_in(task.file, how) : load_document(task.file, task.skin, how);
    }
  } catch (const MissingMesh& error) {
    out = LoadFailed{shown_message(error), error.file(), error.mesh};
  } catch (const std::exception& error) {
    out = task.document ? LoadResult(PolishFailed{shown_message(error)}) : LoadResult(LoadFailed{shown_message(error)});
  }
}

void Loader::begin(Task task, int frames) {
  close();
  slot_.post(std::make_shared<const Task>(std::move(task)), Superseded::finish, frames);
  began_ = std::chrono::steady_clock::now();
}

void Loader::start(const std::string& file, const SkinChoice& skin, int frames) {
  begin({file, skin, std::nullopt}, frames);
  file_ = file;
}

void Loader::polish(const LoadedDocument& document) {
  begin({"", {}, document}, kPreviewFrames);
}

void Loader::cancel() {
  if (!slot_.posted()) return;
  LoadResult report = polishing() ? LoadResult(PolishCancelled{}) : LoadResult(LoadCancelled{});
  close();
  cancelled_ = std::move(report);
}

void Loader::close() {
  slot_.post(std::nullopt, Superseded::cancel);
  cancelled_.reset();
}

void Loader::wait() const {
  if (slot_.posted()) slot_.wait();
}

std::optional<LoadResult> Loader::take() {
  if (cancelled_) return std::exchange(cancelled_, std::nullopt);
  const auto result = slot_.take();
  if (!result) return std::nullopt;
  const auto* document = std::get_if<LoadedDocument>(result.get());
  if (document != nullptr && document->previewed()) {
    const Task polish{"", {}, *document};
    slot_.post(std::make_shared<const Task>(polish), Superseded::finish, kPreviewFrames - 1);  // this frame counts
  }
  return *result;
}

bool Loader::loading() const {
  const auto task = slot_.posted();
  return task && !(*task)->document;
}

bool Loader::polishing() const {
  const auto task = slot_.posted();
  return task && (*task)->document;
}

double Loader::seconds() const {
  return busy() ? std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() : 0.0;
}

namespace {

/// Number of frames in which a script sees that a large file is being loaded.
constexpr int kLoadFrames = 8;
constexpr std::uintmax_t kLargeFile = 32'000'000;  // [bytes]

/// Whether the cameras should turn to a mesh because its size differs: it has another unit.
bool differs_in_size(const TriMesh& a, const TriMesh& b) {
  constexpr double kMinRatio = 1.5;
  const double ratio = a.bounds().diagonal() / b.bounds().diagonal();
  return ratio > kMinRatio || ratio < 1 / kMinRatio;
}

}  // namespace

void edit_layout_of_scene(Document& document, ui::SceneLayout layout, ProjectPtr project, OpenMeshPtr mesh,
                          SensorModelPtr model) {
  const std::string file = layout.file;
  const bool is_compiled = model != nullptr;
  document.scene_layout = std::move(layout);
  document.set_model(std::move(model));
  document.edits.open(std::move(project), std::move(mesh), file, "", is_compiled);
}

void leave_layout_of_scene(Document& document) {
  if (!document.scene_layout) return;
  document.scene_layout.reset();
  document.set_model(nullptr);
  document.edits.close();
}

void report_sample_notes(const SensorModel& model, HostEvents& events) {
  for (const std::string& note : notes_of_samples(model)) events.emplace_back(HostMessage{Severity::warning, note});
}

void Document::open(const std::string& file, const SkinChoice& skin) {
  is_reloading_ = false;
  recovered_.reset();
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  loader.start(file, skin, !missing && size > kLargeFile ? kLoadFrames : 0);
}

void Document::recover(const LostDocument& lost) {
  open(lost.file.string(), {});
  recovered_ = lost;
}

void Document::reload() {
  if (!opened_ || opened_->file.empty()) return;
  is_reloading_ = true;
  loader.start(opened_->file, opened_->skin);
}

void Document::close() {
  loader.close();
  opened_.reset();
  scene_layout.reset();
  edits.close();
}

/// The models of a scene's layout are polished where the layout is built.
void Document::polish() {
  if (kind() == DocumentKind::scene) return;
  if (!loader.busy() && opened_ && opened_->previewed()) loader.polish(*opened_);
}

void Document::resume_polishing() {
  if (opened_ && opened_->model != retained_preview_) polish();
}

/// Gives a document that was not saved the name and the file that it had.
void Document::restore_origin() {
  if (!recovered_ || opened_->file != recovered_->file.string() || !opened_->project) return;
  opened_->file = recovered_->origin;
  if (std::filesystem::path(opened_->file).extension() != ".taxelproj") opened_->kind = DocumentKind::layout;
  const std::filesystem::path mesh = opened_->project->layout.mesh.file;
  if (mesh.parent_path() == recovered_->file.parent_path()) {  // the built-in mesh, written next to the document
    Project project = *opened_->project;
    project.layout.mesh.file = built_in_mesh().name;
    opened_->project = std::make_shared<const Project>(std::move(project));
  }
}

void Document::show(LoadedDocument document, const Scenario& scenario) {
  const bool has_scenario = document.kind == DocumentKind::project;
  opened_ = std::move(document);
  scene_layout.reset();
  restore_origin();
  if (!opened_->project) return edits.close();
  if (!has_scenario && opened_->project->scenario != scenario) {
    Project project = *opened_->project;
    project.scenario = scenario;
    opened_->project = std::make_shared<const Project>(std::move(project));
  }
  edits.open(opened_->project, opened_->mesh, opened_->file, opened_->problem);
  if (std::exchange(recovered_, std::nullopt)) edits.mark_unsaved();
}

bool Document::is_reload_of_edited(const LoadedDocument& document) const {
  return is_reloading_ && edits.is_open() && document.project && opened_ && document.file == opened_->file;
}

void Document::accept_reload(const LoadedDocument& document, HostEvents& events) {
  loader.close();  // the samples of an edited layout are polished where the layout is built
  const MeshRef& before = edits.project()->layout.mesh;
  MeshRef mesh = document.project->layout.mesh;
  Edit edit = ReplaceLayout{document.project->layout};
  if (document.kind == DocumentKind::project) edit = ReplaceProject{*document.project};
  if (document.kind == DocumentKind::mesh) {  // the file knows no unit and no taxels
    const bool same_unit = before.scale == mesh.scale, same = before.sha256 == mesh.sha256;
    mesh.scale = before.scale;
    mesh.repair = before.repair;
    if (same_unit) edits.add_mesh(mesh, document.mesh);
    edit = ReplaceMesh{mesh, same ? *edits.project()->layout.sampling.region : std::vector<int>{}};
  } else {
    edits.add_mesh(mesh, document.mesh);
  }
  const std::uint64_t revision = edits.revision();
  try {
    edits.edit(edit);
  } catch (const Error& error) {
    events.emplace_back(HostMessage{Severity::error, document.file + ": " + shown_message(error)});
    return;
  }
  if (document.kind != DocumentKind::mesh) edits.mark_saved();
  events.emplace_back(Reloaded{});
  const std::string name = std::filesystem::path(document.file).filename().string();
  events.emplace_back(HostMessage{Severity::note, edits.revision() == revision
                                                      ? name + " was read again: nothing has changed."
                                                      : name + " was read again. Undo takes it back."});
}

void Document::accept_built(HostEvents& events) {
  SensorModelPtr model = edits.take_model();
  if (!model || !opened_) return;
  events.emplace_back(ModelBuilt{opened_->model && differs_in_size(*opened_->model->mesh, *model->mesh)});
  opened_->model = std::move(model);
}

void Document::accept_polished(const Polished& models, HostEvents& events) {
  if (!opened_ || opened_->model != models.preview) return;  // the document of the preview was refused or closed
  opened_->model = models.model;
  report_sample_notes(*opened_->model, events);
}

void Document::retain_preview(SensorModelPtr preview, Severity severity, const std::string& why, HostEvents& events) {
  events.emplace_back(HostMessage{severity, why});
  if (!preview) return;
  report_sample_notes(*preview, events);
  retained_preview_ = std::move(preview);
}

void Document::saved_as(const std::string& file) {
  opened_->file = file;
  opened_->kind = DocumentKind::project;
  edits.mark_saved();
}

}  // namespace taxel::studio
