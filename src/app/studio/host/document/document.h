// The open document: how it is loaded, polished, edited and read again.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/studio/host/document/autosave.h"
#include "app/studio/host/document/edit_session.h"
#include "app/studio/host/document/loader.h"
#include "app/studio/host/run/host_event.h"
#include "core/sensor/sensor_cache.h"

namespace taxel::studio {

class Document {
 public:
  /// `cache` has the parts of compiled sensors, and must live as long as the document. `built` is called with each
  /// model of an edited layout, on the worker that built the model.
  Document(JobExecutor& executor, SensorCache& cache, ModelSlot::Built built)
      : loader_(executor, cache), edits_(executor, cache, std::move(built)) {}

  /// Begins to load a file, or the built-in fingertip if `file` is empty. `skin` is for a layout of another program.
  void open(const std::string& file, const SkinChoice& skin = {});
  /// Begins to load the layout and the scenario of an episode.
  void open(const EpisodeChoice& episode);
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
  [[nodiscard]] Loader& loader() { return loader_; }
  [[nodiscard]] const Loader& loader() const { return loader_; }
  [[nodiscard]] EditSession& edits() { return edits_; }
  [[nodiscard]] const EditSession& edits() const { return edits_; }

 private:
  void restore_origin();

  Loader loader_;
  EditSession edits_;
  std::optional<LoadedDocument> opened_;
  std::optional<LostDocument> recovered_;  // the document that is being loaded was not saved
  SensorModelPtr retained_preview_;        // preview that is polished only on request: it was cancelled or failed
  bool is_reloading_ = false;
};

/// Reports the notes about the samples of a model.
void report_sample_notes(const SensorModel& model, HostEvents& events);

}  // namespace taxel::studio
