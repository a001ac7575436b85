// The document that is edited: its history, and the models that are compiled of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studio/app/values/shown.h"
#include "app/studio/document/model_slot.h"
#include "core/document/history.h"

namespace taxel::studio {

class EditSession {
 public:
  /// See ModelSlot.
  EditSession(JobExecutor& executor, SensorCache& cache, std::function<void()> wake, ModelSlot::Built built = {})
      : models_(executor, cache, std::move(wake), std::move(built)) {}

  /// Another document, on this mesh, whose model is there already: saved, with no step to undo. `problem`: why it
  /// cannot be simulated.
  void open(ProjectPtr project, OpenMeshPtr mesh, std::string file, std::string problem = "");
  void close();
  [[nodiscard]] bool is_open() const { return history_.has_value(); }

  /// Edits throw Error as History::apply does, and then nothing has changed.
  void edit(const Edit& edit, taxel::Gesture gesture = {});
  /// Several as one step, which has the name of the last.
  void edit_together(const std::vector<Edit>& edits);
  void cancel(std::uint64_t gesture);
  void end_gesture();
  void undo();
  void redo();

  /// The mesh of a reference, for edits that bring it in: one that is not told is read from its file.
  void add_mesh(const MeshRef& ref, OpenMeshPtr mesh);
  /// That of the present project; null: not read yet, or it cannot be read.
  [[nodiscard]] OpenMeshPtr mesh() const;
  /// Why the present project cannot be compiled, or simulated; empty: it can, or that is not known yet.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  [[nodiscard]] const ProjectPtr& project() const { return history_->project(); }
  [[nodiscard]] std::uint64_t revision() const { return history_->revision(); }
  [[nodiscard]] bool dirty() const { return history_ && history_->dirty(); }
  void mark_saved() { history_->mark_saved(); }
  void mark_unsaved() { history_->mark_unsaved(); }

  /// The newest model of what is edited, once; the one before stays good until then.
  SensorModelPtr take_model();
  void wait() { models_.wait(); }
  /// The model that was taken last is of the present project.
  [[nodiscard]] bool compiled() const { return history_ && compiled_ == asked_; }
  [[nodiscard]] bool building() const { return models_.busy(); }

  void fill(ui::Editing& editing, ui::Polishing& polishing) const;

 private:
  void rebuild();
  void rebuild_if_changed();

  std::optional<History> history_;
  std::shared_ptr<OpenMeshes> meshes_ = std::make_shared<OpenMeshes>();
  std::string file_;
  ProjectPtr built_;            ///< what the newest model is, or will be, compiled of: its layout is the project's
  std::uint64_t asked_ = 0;     ///< number of requested models
  std::uint64_t compiled_ = 0;  ///< number of the one that was taken last
  std::uint64_t together_ = 0;  ///< counts edit_together()
  std::string problem_;
  ModelSlot models_;
};

}  // namespace taxel::studio
