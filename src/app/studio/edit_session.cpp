#include "app/studio/edit_session.h"

#include <utility>

namespace taxel::studio {

void EditSession::open(ProjectPtr project, TriMeshPtr mesh, std::string mesh_sha256, std::string file) {
  worker_.clear();
  history_.emplace(*project);
  mesh_ = std::move(mesh);
  mesh_sha256_ = std::move(mesh_sha256);
  file_ = std::move(file);
  compiled_ = history_->revision();
  problem_.clear();
}

void EditSession::close() {
  worker_.clear();
  history_.reset();
  mesh_.reset();
  problem_.clear();
}

void EditSession::rebuild() {
  worker_.build({history_->revision(), history_->project(), mesh_, mesh_sha256_, file_});
}

void EditSession::edit(const Edit& edit, taxel::Gesture gesture) {
  if (history_ && history_->apply(edit, gesture)) rebuild();
}

void EditSession::cancel(std::uint64_t gesture) {
  if (!history_) return;
  const std::uint64_t before = history_->revision();
  history_->cancel(gesture);
  if (history_->revision() != before) rebuild();
}

void EditSession::end_gesture() {
  if (history_) history_->end_gesture();
}

void EditSession::undo() {
  if (!history_ || !history_->can_undo()) return;
  history_->undo();
  rebuild();
}

void EditSession::redo() {
  if (!history_ || !history_->can_redo()) return;
  history_->redo();
  rebuild();
}

SensorModelPtr EditSession::take_model() {
  std::optional<BuiltModel> built = worker_.take();
  if (!built || !history_) return nullptr;
  const bool newest = built->revision == history_->revision();
  if (newest) problem_ = built->problem;
  if (built->model) compiled_ = built->revision;
  return built->model;
}

void EditSession::fill(ui::Editing& editing, ui::Polishing& polishing, bool by_clock) const {
  editing = {};
  if (!history_) return;
  editing.project = history_->project();
  editing.compiled = compiled();
  editing.problem = problem_;
  editing.undo = history_->undo_name();
  editing.redo = history_->redo_name();
  editing.undo_depth = history_->undo_depth();
  editing.redo_depth = history_->redo_depth();
  editing.dirty = history_->dirty();
  if (worker_.polishing()) polishing = {true, by_clock ? worker_.fraction() : 0};
}

}  // namespace taxel::studio
