#include "app/studio/host/document/edit_session.h"

#include <utility>

#include "app/studio/host/document/documents.h"
#include "core/base/error.h"
#include "core/base/text/message.h"

namespace taxel::studio {
namespace {

/// Throws Error or Cancelled.
void compile_model(const ModelInput& input, SensorCache& cache, BuiltModel& out, Progress& progress) {
  SensorBuild how(&progress);
  how.cache = &cache;
  how.quality = input.quality;
  out.number = input.number;
  const Layout& layout = input.project->layout;
  try {
    const OpenMeshPtr mesh = input.meshes->get(layout.mesh);
    ShownModel shown = shown_model(layout, mesh->loaded.mesh, [&](const Layout& compiled) {
      return build_sensor_model(compiled, mesh->loaded.mesh, mesh->loaded.sha256, input.file, how);
    });
    out.model = std::move(shown.model);
    out.problem = std::move(shown.problem);
  } catch (const Error& error) {  // without the file, which the window names
    out.problem = shown_part(error.where().empty() ? error.message() : error.where() + ": " + error.message());
  }
}

}  // namespace

ModelSlot::ModelSlot(JobExecutor& executor, SensorCache& cache, Built built)
    : slot_(executor, Priority::normal,
            [&cache, built = std::move(built)](const ModelInput& input, BuiltModel& out, Progress& progress) {
              compile_model(input, cache, out, progress);
              if (built && out.model) built(out.model);
            }) {}

void ModelSlot::build(ModelInput input) {
  const std::optional<ModelInput> before = slot_.posted();
  const bool cancels = before && (before->quality == SampleQuality::polished ||
                                  before->project->layout.mesh.repair != input.project->layout.mesh.repair);
  slot_.post(std::move(input), cancels ? Superseded::cancel : Superseded::finish);
}

std::optional<BuiltModel> ModelSlot::take() {
  std::optional<ModelInput> input = slot_.posted();
  const auto built = slot_.take();
  if (!built) return std::nullopt;
  const bool is_preview = built->model && built->model->quality == SampleQuality::preview;
  if (is_preview && input && input->number == built->number && input->quality == SampleQuality::preview) {
    input->quality = SampleQuality::polished;
    slot_.post(std::move(input));
  }
  return *built;
}

bool ModelSlot::polishing() const {
  const std::optional<ModelInput> input = slot_.posted();
  return input && input->quality == SampleQuality::polished;
}

namespace {

/// Base of the gesture numbers of edit_together(). Gestures of the user are numbered from 1.
constexpr std::uint64_t kTogether = std::uint64_t{1} << 62U;

}  // namespace

void EditSession::open(ProjectPtr project, OpenMeshPtr mesh, std::string file, std::string problem, bool is_compiled) {
  models_.clear();
  history_.emplace(*project);
  meshes_ = std::make_shared<OpenMeshes>();  // a job may still build a model of the previous document with its meshes
  if (mesh) meshes_->add(project->layout.mesh, std::move(mesh));
  file_ = std::move(file);
  steps_ = std::make_shared<const std::vector<HistoryStep>>(history_->steps());
  built_ = history_->project();
  compiled_ = ++asked_;
  problem_ = std::move(problem);
  if (!is_compiled) rebuild();
}

void EditSession::close() {
  models_.clear();
  history_.reset();
  steps_.reset();
  meshes_ = std::make_shared<OpenMeshes>();
  problem_.clear();
}

void EditSession::rebuild() {
  built_ = history_->project();
  models_.build({++asked_, built_, meshes_, file_});
}

/// Lists the steps again, and compiles a new model if the layout has changed. The scenario and other parts of the
/// project need no compilation.
void EditSession::accept_change() {
  steps_ = std::make_shared<const std::vector<HistoryStep>>(history_->steps());
  if (history_->project()->layout != built_->layout) rebuild();
}

void EditSession::edit(const Edit& edit, taxel::Gesture gesture) {
  if (history_ && history_->apply(edit, gesture)) accept_change();
}

void EditSession::edit_together(const std::vector<Edit>& edits) {
  if (!history_) return;
  const std::uint64_t gesture = kTogether + ++together_, before = history_->revision();
  try {
    for (const Edit& edit : edits) history_->apply(edit, {gesture});
  } catch (const Error&) {
    history_->cancel(gesture);
    throw;
  }
  history_->end_gesture();
  if (history_->revision() != before) accept_change();
}

void EditSession::add_mesh(const MeshRef& ref, OpenMeshPtr mesh) {
  const OpenMeshPtr earlier = meshes_->find(ref);
  if (earlier && earlier->loaded.sha256 == mesh->loaded.sha256) return;
  meshes_->add(ref, std::move(mesh));
  if (earlier && history_ && same_file(history_->project()->layout.mesh, ref)) rebuild();
}

OpenMeshPtr EditSession::mesh() const {
  return history_ ? meshes_->find(history_->project()->layout.mesh) : nullptr;
}

void EditSession::cancel(std::uint64_t gesture) {
  if (!history_) return;
  const std::uint64_t before = history_->revision();
  history_->cancel(gesture);
  if (history_->revision() != before) accept_change();
}

void EditSession::end_gesture() {
  if (history_) history_->end_gesture();
}

void EditSession::undo() {
  if (!history_ || !history_->can_undo()) return;
  history_->undo();
  accept_change();
}

void EditSession::redo() {
  if (!history_ || !history_->can_redo()) return;
  history_->redo();
  accept_change();
}

void EditSession::go_to(std::uint64_t revision) {
  if (!history_ || history_->revision() == revision) return;
  history_->go_to(revision);
  accept_change();
}

SensorModelPtr EditSession::take_model() {
  std::optional<BuiltModel> built = models_.take();
  if (!built || !history_) return nullptr;
  const bool newest = built->number == asked_;
  if (newest) problem_ = built->problem;
  if (built->model) compiled_ = built->number;
  return built->model;
}

void EditSession::fill(ui::Editing& editing, ui::Polishing& polishing) const {
  editing = {};
  if (!history_) return;
  editing.project = history_->project();
  editing.compiled = compiled();
  editing.problem = problem_;
  if (const OpenMeshPtr open_mesh = mesh()) {
    editing.mesh_findings = std::shared_ptr<const MeshFindings>(open_mesh, &open_mesh->findings);
    editing.mesh_sha256 = open_mesh->loaded.sha256;
  }
  editing.undo = history_->undo_name();
  editing.redo = history_->redo_name();
  editing.undo_depth = history_->undo_depth();
  editing.redo_depth = history_->redo_depth();
  editing.steps = steps_;
  editing.saved_revision = history_->saved_revision();
  editing.dirty = history_->dirty();
  if (models_.polishing()) polishing = {true, models_.fraction()};
}

}  // namespace taxel::studio
