// What is edited, and how the simulation comes to read by it.
#include <algorithm>
#include <utility>

#include "app/studio/run/session.h"

namespace taxel::studio {

namespace {

bool same_taxels(const Layout& a, const Layout& b) {
  return std::equal(a.taxels.begin(), a.taxels.end(), b.taxels.begin(), b.taxels.end(),
                    [](const Taxel& x, const Taxel& y) { return x.id == y.id; });
}

bool same_mesh(const TriMeshPtr& a, const TriMeshPtr& b) {
  return a == b || (a->faces() == b->faces() && a->vertices() == b->vertices());
}

/// By so much that the cameras should turn to it: another unit.
bool differ_in_size(const TriMesh& a, const TriMesh& b) {
  constexpr double kMuch = 1.5;
  const double ratio = a.bounds().diagonal() / b.bounds().diagonal();
  return ratio > kMuch || ratio < 1 / kMuch;
}

}  // namespace

void Session::recover(const LostDocument& lost) {
  open(lost.file.string());
  recovered_ = lost;
}

/// What was kept of a document goes by the name and file that the document had.
void Session::restore_origin() {
  if (!recovered_ || document_->file != recovered_->file.string() || !document_->project) return;
  document_->file = recovered_->origin;
  if (std::filesystem::path(document_->file).extension() != ".taxelproj") document_->kind = DocumentKind::layout;
  const std::filesystem::path mesh = document_->project->layout.mesh.file;
  if (mesh.parent_path() == recovered_->file.parent_path()) {  // the built-in one, which was kept beside it
    Project project = *document_->project;
    project.layout.mesh.file = built_in_mesh().name;
    document_->project = std::make_shared<const Project>(std::move(project));
  }
}

void Session::show_document(Document document) {
  document_ = std::move(document);
  const bool was_project = document_->kind == DocumentKind::project;
  restore_origin();
  hand_over_wanted_ = false;
  if (document_->project) {
    if (was_project) {
      scenario_ = document_->project->scenario;
    } else if (document_->project->scenario != scenario_) {  // a layout knows none: the last one stays
      Project project = *document_->project;
      project.scenario = scenario_;
      document_->project = std::make_shared<const Project>(std::move(project));
    }
    edits_.open(document_->project, document_->mesh, document_->file, document_->problem);
    if (std::exchange(recovered_, std::nullopt)) edits_.mark_unsaved();
  } else {
    edits_.close();
  }
}

void Session::after_edit(bool simulated) {
  if (probe_request_) edited_at_ = std::chrono::steady_clock::now();
  // The samples of what was loaded are not wanted any more; those of the edited layout are polished where it is built.
  if (loader_.polishing() && !pending_) loader_.close();
  hand_over_wanted_ = hand_over_wanted_ || simulated || holds_run();
}

void Session::press(std::optional<Probe> probe) {
  probe_request_ = std::move(probe);
  if (!probe_request_) {
    pressed_.reset();
    edited_at_.reset();
    edit_latency_.reset();
  }
  jobs_.probe.press(document_ ? document_->model : nullptr, probe_request_);
}

/// The reading that was shown stays until there is one of the model shown now.
void Session::take_reading(SessionNews& news) {
  const SensorModelPtr model = document_ ? document_->model : nullptr;
  jobs_.probe.press(model, probe_request_);
  if (!by_clock_) {
    jobs_.probe.wait();
    jobs_.measure.wait();
  }
  if (ui::MeasuredPtr measured = jobs_.measure.newest(); measured != measured_) {
    measured_ = std::move(measured);
    news.new_reading = true;
  }
  if (pressed_ && pressed_->model != model) pressed_.reset();
  ui::PressedProbePtr newest = jobs_.probe.newest();
  if (!newest || newest == pressed_ || newest->model != model) return;
  pressed_ = std::move(newest);
  news.new_reading = true;
  if (!edited_at_ || !edits_.compiled()) return;
  edit_latency_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - *edited_at_).count();
  edited_at_.reset();
}

void Session::study(const std::optional<ui::StudyRequest>& request) {
  if (!request) return jobs_.study.post(std::nullopt, Superseded::cancel);
  if (!document_ || !document_->model) return;
  jobs_.study.post(StudyInput{*request, document_->model}, Superseded::cancel);
  if (!by_clock_) jobs_.study.wait();
}

/// Those that were shown stay until there are some of what is shown now.
void Session::take_fields(SessionNews& news) {
  ui::FieldsRequest request{{}, field_map_, field_weights_};
  if (field_mode_ == ui::Mode::simulate && frame_ && frame_->scene) {
    request.models = frame_->scene->sensors;
  } else if (document_ && document_->model) {
    request.models = {document_->model};
  }
  jobs_.fields.show(request);
  if (!by_clock_) jobs_.fields.wait();
  ui::ShownFieldsPtr newest = jobs_.fields.newest();
  if (newest == shown_fields_ || (newest && newest->request != request)) return;
  shown_fields_ = std::move(newest);
  news.new_reading = true;
}

void Session::saved_as(const std::string& file) {
  document_->file = file;
  document_->kind = DocumentKind::project;
  edits_.mark_saved();
}

/// Not by clock it waits for what is built, so that the same edits give the same pictures.
void Session::take_edited(SessionNews& news) {
  if (!by_clock_) edits_.wait();
  SensorModelPtr model = edits_.take_model();
  if (!model || !document_) return;
  news.resized = document_->model && differ_in_size(*document_->model->mesh, *model->mesh);
  document_->model = std::move(model);
  news.new_model = true;
}

/// What was read again is one step of the history: undo brings back what was there, with its mesh.
void Session::accept_reload(const Document& document, SessionNews& news) {
  loader_.close();  // what is edited is polished where it is built
  const MeshRef& before = edits_.project()->layout.mesh;
  MeshRef mesh = document.project->layout.mesh;
  Edit edit = ReplaceLayout{document.project->layout};
  if (document.kind == DocumentKind::project) edit = ReplaceProject{*document.project};
  if (document.kind == DocumentKind::mesh) {  // the file knows no unit and no taxels
    const bool same_unit = before.scale == mesh.scale, same = before.sha256 == mesh.sha256;
    mesh.scale = before.scale;
    mesh.repair = before.repair;
    if (same_unit) edits_.add_mesh(mesh, document.mesh);
    edit = ReplaceMesh{mesh, same ? *edits_.project()->layout.sampling.region : std::vector<int>{}};
  } else {
    edits_.add_mesh(mesh, document.mesh);
  }
  const std::uint64_t revision = edits_.revision();
  try {
    edits_.edit(edit);
  } catch (const Error& error) {
    news.messages.emplace_back(Severity::error, document.file + ": " + error.what());
    return;
  }
  if (document.kind != DocumentKind::mesh) edits_.mark_saved();
  news.reloaded = true;
  const std::string name = std::filesystem::path(document.file).filename().string();
  news.messages.emplace_back(Severity::note, edits_.revision() == revision
                                                 ? name + " was read again: nothing has changed."
                                                 : name + " was read again. Undo takes it back.");
}

/// Where the taxels are the same ones, the run goes on with new readings; else its rows would not fit, and it begins
/// anew.
void Session::hand_over_newest() {
  if (!hand_over_wanted_ || !document_ || !document_->model || edits_.building() || polished_ || pending_) return;
  hand_over_wanted_ = false;
  if (!simulates_document_ || !frame_ || frame_->simulated->sensors.empty()) return;
  const SensorModelPtr& simulated = frame_->simulated->sensors.front();
  if (simulated == document_->model) return;
  if (same_taxels(simulated->layout, document_->model->layout) && same_mesh(simulated->mesh, document_->model->mesh)) {
    polished_ = Replacement{Polished{simulated, document_->model}};
  } else if (document_->model->taxel_count() > 0 && edits_.problem().empty()) {
    build_scene({.document = *document_,
                 .in_scenario = true,
                 .scenario = scenario_,
                 .play = playing(),
                 .framed = false,
                 .another = false,
                 .shown = false});
  }
}

}  // namespace taxel::studio
