// What is edited, and how the simulation comes to read by it.
#include <algorithm>
#include <utility>

#include "app/studio/session.h"

namespace taxel::studio {

namespace {

bool same_taxels(const Layout& a, const Layout& b) {
  return std::equal(a.taxels.begin(), a.taxels.end(), b.taxels.begin(), b.taxels.end(),
                    [](const Taxel& x, const Taxel& y) { return x.id == y.id; });
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
    edits_.open(document_->project, document_->mesh.mesh, document_->mesh.sha256, document_->file);
    if (was_project) scenario_ = document_->project->scenario;
    if (std::exchange(recovered_, std::nullopt)) edits_.mark_unsaved();
  } else {
    edits_.close();
  }
}

void Session::after_edit(bool simulated) {
  // The samples of what was loaded are not wanted any more; those of the edited layout are polished where it is built.
  if (loader_.polishing() && !pending_) loader_.close();
  hand_over_wanted_ = hand_over_wanted_ || simulated;
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
  document_->model = std::move(model);
  news.new_model = true;
}

/// Where the taxels are the same ones, the run goes on with new readings; else its rows would not fit, and it begins
/// anew.
void Session::hand_over_newest() {
  if (!hand_over_wanted_ || !document_ || !document_->model || edits_.building() || polished_ || pending_) return;
  hand_over_wanted_ = false;
  if (!simulates_document_ || !frame_ || frame_->simulated->sensors.empty()) return;
  const SensorModelPtr& simulated = frame_->simulated->sensors.front();
  if (simulated == document_->model) return;
  if (same_taxels(simulated->layout, document_->model->layout)) {
    polished_ = Replacement{Polished{simulated, document_->model}};
  } else if (document_->model->taxel_count() > 0) {
    build_scene({.document = *document_,
                 .sweep = true,
                 .scenario = scenario_,
                 .play = playing(),
                 .framed = false,
                 .another = false,
                 .shown = false});
  }
}

}  // namespace taxel::studio
