// The open document: how it is loaded, polished, edited and read again.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/studio/host/document/document_files.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/document/edit_session.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/host/run/host_event.h"
#include "core/sensor/sensor_cache.h"

namespace taxel::studio {

struct LoadFailed {
  std::string reason;
  std::string layout = {};  ///< file whose mesh is missing, or empty if the load failed for another reason
  std::string mesh = {};    ///< path of the missing mesh
};
struct LoadCancelled {};
/// The same layout with polished samples.
struct Polished {
  SensorModelPtr preview;  ///< model that is replaced
  SensorModelPtr model;
};
struct PolishFailed {
  std::string reason;
};
struct PolishCancelled {};
using LoadResult = std::variant<LoadedDocument, LoadFailed, LoadCancelled, Polished, PolishFailed, PolishCancelled>;

/// Loads documents on a worker while the window stays live: a document with preview samples first, which can be
/// displayed and simulated, and then the same document with polished samples.
class Loader {
 public:
  /// Reloading costs only the parts of a layout that changed, because of `cache`, which must live longer.
  Loader(JobExecutor& executor, SensorCache& cache);

  /// Number of frames in which a script sees a preview, long enough to aim at it and to press and release a button.
  static constexpr int kPreviewFrames = 4;

  /// Begins to load a file, or the built-in fingertip if `file` is empty. A running job is cancelled and its results
  /// are dropped. When a document with preview samples is taken, its samples are polished. `skin` chooses the mesh for
  /// a layout of another program. A script sees for `frames` frames that the file is being loaded.
  void start(const std::string& file, const SkinChoice& skin = {}, int frames = 0);
  /// Begins to polish the samples of a document, whose preview a script sees for kPreviewFrames. A running job is
  /// cancelled and its results are dropped.
  void polish(const LoadedDocument& document);
  /// Cancels the running job, which take() reports next, even if the worker has finished by then.
  void cancel();
  /// Cancels the running job without a report.
  void close();
  /// Waits until take() has a result, or no job runs.
  void wait() const;
  /// Returns the next result, once.
  std::optional<LoadResult> take();

  [[nodiscard]] bool busy() const { return slot_.posted() || cancelled_; }
  [[nodiscard]] bool cancelled() const { return cancelled_.has_value(); }  ///< whether take() will report it
  [[nodiscard]] bool loading() const;                                      ///< whether the document is not there yet
  [[nodiscard]] bool polishing() const;                            ///< whether the samples of a document are polished
  [[nodiscard]] const std::string& file() const { return file_; }  ///< file of the last start()
  /// Returns the finished fraction of loading or of polishing.
  [[nodiscard]] double fraction() const { return slot_.newest() ? 1 : slot_.fraction(); }
  /// Returns the name of the step that loading or polishing is in, as in "Filling holes", or "".
  [[nodiscard]] std::string step() const { return slot_.step(); }
  [[nodiscard]] double seconds() const;  ///< time since it began

 private:
  /// A file to load, or a document whose samples are to be polished.
  struct Task {
    std::string file;
    SkinChoice skin;
    std::optional<LoadedDocument> document;
  };
  static void run(const Task& task, SensorCache& cache, LoadResult& out, Progress& progress);
  void begin(Task task, int frames);

  std::string file_;
  std::optional<LoadResult> cancelled_;  ///< report for take()
  std::chrono::steady_clock::time_point began_;
  NewestWins<std::shared_ptr<const Task>, LoadResult> slot_;
};

class Document {
 public:
  /// `cache` has the parts of compiled sensors, and must live as long as the document. `built` is called with each
  /// model of an edited layout, on the worker that built the model.
  Document(JobExecutor& executor, SensorCache& cache, ModelSlot::Built built)
      : loader(executor, cache), edits(executor, cache, std::move(built)) {}

  Loader loader;                                ///< the file that is loaded
  EditSession edits;                            ///< history and models of the open document
  std::optional<ui::SceneLayout> scene_layout;  ///< layout of the open scene that `edits` edits, or empty

  /// Begins to load a file, or the built-in fingertip if `file` is empty. `skin` is for a layout of another program.
  void open(const std::string& file, const SkinChoice& skin = {});
  /// Begins to load a document that was not saved.
  void recover(const LostDocument& lost);
  /// Begins to read the file of the document again.
  void reload();
  void close();
  /// Begins to polish the samples of the document, if they are a preview's.
  void polish();
  /// Polishes the samples after another document could not be loaded, unless the user cancelled that before.
  void resume_polishing();
  /// Displays another document. `scenario` is that of a document that has none.
  void show(LoadedDocument document, const Scenario& scenario);
  /// Replaces the edited document by the same file that was read again: one step to undo.
  void accept_reload(const LoadedDocument& document, HostEvents& events);
  /// Whether a loaded document replaces the edited one as an edit.
  [[nodiscard]] bool is_reload_of_edited(const LoadedDocument& document) const;
  /// Displays the newest model of the edited layout, if there is another one.
  void accept_built(HostEvents& events);
  /// Displays the polished samples of the same layout, and reports the notes about them.
  void accept_polished(const Polished& models, HostEvents& events);
  /// Remembers that a preview was not polished, with the reason and the notes about its samples.
  void retain_preview(SensorModelPtr preview, Severity severity, const std::string& why, HostEvents& events);
  void retain_preview(SensorModelPtr preview) { retained_preview_ = std::move(preview); }
  /// Sets the model of a scene's document, which its sensors are compiled from.
  void set_model(SensorModelPtr model) { opened_->model = std::move(model); }
  void saved_as(const std::string& file);

  [[nodiscard]] const std::optional<LoadedDocument>& opened() const { return opened_; }
  [[nodiscard]] SensorModelPtr model() const { return opened_ ? opened_->model : nullptr; }
  /// File of the open document, or empty if there is none or it is built in.
  [[nodiscard]] std::string file() const { return opened_ ? opened_->file : ""; }
  [[nodiscard]] DocumentKind kind() const { return opened_ ? opened_->kind : DocumentKind::layout; }
  /// Whether the tip and the pad of the document are a guess.
  [[nodiscard]] bool frame_is_guess() const { return opened_ && opened_->frame_is_guess; }
  [[nodiscard]] bool is_reloading() const { return is_reloading_; }

 private:
  void restore_origin();

  std::optional<LoadedDocument> opened_;
  std::optional<LostDocument> recovered_;  // the document that is being loaded was not saved
  SensorModelPtr retained_preview_;        // preview that is polished only on request: it was cancelled or failed
  bool is_reloading_ = false;
};

/// Edits a layout of the open scene, and no other one any more. `mesh` is null if it is to be read from its file, and
/// `model` is null if it is not compiled yet.
void edit_layout_of_scene(Document& document, ui::SceneLayout layout, ProjectPtr project, OpenMeshPtr mesh,
                          SensorModelPtr model);
/// Ends editing a layout of the scene. Unsaved edits are lost.
void leave_layout_of_scene(Document& document);

/// Reports the notes about the samples of a model.
void report_sample_notes(const SensorModel& model, HostEvents& events);

}  // namespace taxel::studio
