// Document that is being edited: its history, and the models that are compiled from it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/shown.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/document/history.h"
#include "core/document/project.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

/// A layout to compile.
struct ModelInput {
  std::uint64_t number = 0;  ///< unique number, given by the caller
  ProjectPtr project;
  std::shared_ptr<OpenMeshes> meshes;  ///< read meshes, to which the mesh of the project is added if it is absent
  std::string file;                    ///< name of the layout in messages
  SampleQuality quality = SampleQuality::preview;
  bool operator==(const ModelInput& other) const { return number == other.number && quality == other.quality; }
};

struct BuiltModel {
  std::uint64_t number = 0;  ///< number of the input
  SensorModelPtr model;      ///< the model, or null if `problem` is set
  std::string problem;       ///< reason why the layout cannot be compiled or simulated, or empty
};

/// Compiles the edited layout on a worker: the newest layout wins, so that models follow a drag without delay.
class ModelSlot {
 public:
  using Built = std::function<void(const SensorModelPtr&)>;
  /// `built` is called on the worker with each model, before take() has it.
  ModelSlot(JobExecutor& executor, SensorCache& cache, Built built = {});

  /// Compiles a preview of the layout and, once that was taken, the same layout with polished samples, unless the cache
  /// had them. An input that has not begun is dropped. A preview under way is finished, unless it repairs the mesh in
  /// another way, which may take seconds; polishing is cancelled.
  void build(ModelInput input);
  /// Cancels everything; take() returns nothing of earlier inputs.
  void clear() { slot_.post(std::nullopt, Superseded::cancel); }
  /// The newest result, once.
  std::optional<BuiltModel> take();
  /// Waits until no model is compiled.
  void wait() const { slot_.wait(); }
  /// Whether a model is compiled or was not taken yet.
  [[nodiscard]] bool busy() const { return slot_.busy() || slot_.posted(); }
  /// Whether the samples of the model that was taken last are polished.
  [[nodiscard]] bool polishing() const;
  /// Finished fraction of polishing.
  [[nodiscard]] double fraction() const { return polishing() ? slot_.fraction() : 0; }

 private:
  NewestWins<ModelInput, BuiltModel> slot_;
};

class EditSession {
 public:
  /// See ModelSlot.
  EditSession(JobExecutor& executor, SensorCache& cache, ModelSlot::Built built = {})
      : models_(executor, cache, std::move(built)) {}

  /// Opens another document on this mesh, which is saved and has no step to undo. A null mesh is read from its file.
  /// `problem` is the reason why it cannot be simulated, or empty. Its model is compiled already, or it is compiled
  /// now.
  void open(ProjectPtr project, OpenMeshPtr mesh, std::string file, std::string problem = "", bool is_compiled = true);
  void close();
  [[nodiscard]] bool is_open() const { return history_.has_value(); }

  /// Applies an edit. Throws Error as History::apply() does; nothing has changed then.
  void edit(const Edit& edit, taxel::Gesture gesture = {});
  /// Applies several edits as one step, which has the name of the last edit. Throws Error if one of them fails; nothing
  /// has changed then.
  void edit_together(const std::vector<Edit>& edits);
  void cancel(std::uint64_t gesture);
  void end_gesture();
  void undo();
  void redo();
  /// Undoes or redoes steps until the project has this revision, as History::go_to() does.
  void go_to(std::uint64_t revision);

  /// Adds the mesh of a reference, for edits that use the reference. A mesh that was not added is read from its file.
  void add_mesh(const MeshRef& ref, OpenMeshPtr mesh);
  /// Returns the mesh of the present project, or null if it was not read yet or cannot be read.
  [[nodiscard]] OpenMeshPtr mesh() const;
  /// Returns why the present project cannot be compiled or simulated; empty if it can, or if that is not known yet.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  [[nodiscard]] const ProjectPtr& project() const { return history_->project(); }
  [[nodiscard]] std::uint64_t revision() const { return history_->revision(); }
  [[nodiscard]] bool dirty() const { return history_ && history_->dirty(); }
  void mark_saved() { history_->mark_saved(); }
  void mark_unsaved() { history_->mark_unsaved(); }

  /// Returns the newest model of the edited project, once, or null. The previous model remains valid until then.
  SensorModelPtr take_model();
  /// Returns whether the model that was taken last is of the present project.
  [[nodiscard]] bool compiled() const { return history_ && compiled_ == asked_; }
  /// Returns the models that are compiled for take_model().
  [[nodiscard]] const ModelSlot& models() const { return models_; }

  void fill(ui::Editing& editing, ui::Polishing& polishing) const;

 private:
  void rebuild();
  void accept_change();

  std::optional<History> history_;
  std::shared_ptr<OpenMeshes> meshes_ = std::make_shared<OpenMeshes>();
  std::string file_;
  std::shared_ptr<const std::vector<HistoryStep>> steps_;  ///< steps of the history; null if nothing is open
  ProjectPtr built_;            ///< source of the newest requested model; has the present project's layout
  std::uint64_t asked_ = 0;     ///< number of requested models
  std::uint64_t compiled_ = 0;  ///< number of the model that was taken last
  std::uint64_t together_ = 0;  ///< number of calls of edit_together()
  std::string problem_;
  ModelSlot models_;
};

}  // namespace taxel::studio
