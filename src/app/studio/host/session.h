// The open document, its simulation and the jobs, without a window: the values that there are to display.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/host/document/document.h"
#include "app/studio/host/feature_jobs.h"
#include "app/studio/host/run/handover.h"
#include "app/studio/host/run/run.h"
#include "app/studio/host/run/session_event.h"

namespace taxel::studio {

/// How the simulation and the jobs run.
struct SessionHosts {
  std::unique_ptr<SimHost> simulation;
  JobExecutor& executor;     ///< must live longer than the session
  SensorCache& cache;        ///< parts of compiled sensors; must live longer than the session
  bool is_real_time = true;  ///< false for a script, which gets the same frames every time
};

/// Mediates between the document, the simulation and the jobs. In a script every request has its result in the next
/// update().
class Session {
 public:
  explicit Session(SessionHosts hosts);

  /// Opens a file, or the built-in fingertip if `file` is empty. `skin` is for a layout of another program.
  void open(const std::string& file, const SkinChoice& skin = {}) { document_.open(file, skin); }
  /// Opens an episode of a data set and runs its scenario.
  void open(const EpisodeChoice& episode) { document_.open(episode); }
  /// Opens a document that was not saved, as it was when the program ended.
  void recover(const LostDocument& lost) { document_.recover(lost); }
  /// Reads the document again. Pause, cameras and undo stay.
  void reload() { document_.reload(); }
  void close();
  /// Cancels loading or polishing, whichever runs.
  void cancel_loading() { document_.loader().cancel(); }
  /// Polishes the displayed samples, if they are a preview's.
  void polish();

  /// The edited document. Edits do not change the simulation.
  [[nodiscard]] EditSession& edits() { return document_.edits(); }
  [[nodiscard]] const EditSession& edits() const { return document_.edits(); }
  /// To be called after each edit. If `is_simulated`, the simulation is displayed and reads by the edited layout.
  void after_edit(bool is_simulated);
  /// Requests that the simulation reads by the newest model as soon as it is built.
  void hand_over() { handover_.request(); }
  /// Posts the requests of the tools for the edited layout. After an edit they are posted again.
  void request_about_layout(const ui::App& app) { jobs_.request_about_layout(app, document_.model()); }
  /// Posts the requests of the open panels about the run.
  void request_about_run(const ui::App& app) { jobs_.request_about_run(app, document_.model(), sender()); }
  void saved_as(const std::string& file) { document_.saved_as(file); }
  /// File of the open document, or empty if there is none or it is built in.
  [[nodiscard]] std::string file() const { return document_.opened() ? document_.opened()->file : ""; }
  /// Whether the document that was opened last is kJumpingTaxel.
  [[nodiscard]] bool is_jumping_taxel() const { return document_.loader().file() == kJumpingTaxel; }
  /// Whether the tip and the pad of the document are a guess.
  [[nodiscard]] bool frame_is_guess() const { return document_.opened() && document_.opened()->frame_is_guess; }
  [[nodiscard]] DocumentKind kind() const {
    return document_.opened() ? document_.opened()->kind : DocumentKind::layout;
  }

  /// Returns false if there is nothing to simulate, or it cannot be simulated, which is reported.
  bool run_scenario(const Scenario& scenario);
  /// Sets the scenario of documents that have none, until another one runs.
  void begin_with(const Scenario& scenario) { run_.set_scenario(scenario); }
  /// Leads the scene that is opened next, and each time when it is compiled again.
  void lead_next_scene(LeadRequest lead) { first_lead_ = std::move(lead); }
  void set_playing(bool plays);
  /// Steps through recorded steps; the step after the newest one is simulated.
  void step_by(int steps);
  void scrub(std::uint64_t step);
  void replay(int direction);  ///< plays recorded steps; 0 stops
  /// Sets the recorded steps to repeat. Without them a replay stops at the end.
  void set_loop(std::optional<StepRange> range) { run_.set_loop(range); }
  void set_breakpoints(const Breakpoints& breakpoints) { run_.send(BreakpointsCommand{breakpoints}); }
  void set_history_limits(const StepHistoryLimits& limits) { run_.send(StepHistoryLimitsCommand{limits}); }
  void reset();
  void set_speed(double factor) { run_.set_speed(factor); }
  /// Sends a command of the user to the running scene.
  void send(SimCommand command);
  /// Attaches a layout to geoms of the open scene, which is compiled again and plays or pauses as before.
  void attach(const std::vector<std::string>& geoms, const std::string& layout);
  void detach(const std::string& geom);
  void save_scene(const std::string& file) { run_.send(SaveSceneCommand{file}); }

  /// Records every step until recording is switched off or the run ends; then the recording is written to `file`.
  /// With `error_bars` each step is measured as well.
  void record(bool on, const std::string& file, bool error_bars);
  /// Writes a recording that could not be written to its own file.
  void write_recording(const std::string& file) { run_.send(WriteRecordingCommand{file}); }
  /// Sets the folder for the journals of recordings.
  void keep_recordings_in(const std::string& folder) { run_.set_journal_folder(folder); }
  /// Writes the recorded steps, or those of the loop.
  void export_recording(const std::string& file, bool error_bars);

  /// Takes the results of the jobs and the replies of the simulation. A script sees a preview for some frames, unless
  /// `without_delay`.
  SessionEvents update(bool without_delay = false);
  /// Reports the time that has passed [s], by which the simulation or a replay advances.
  void advance(double seconds) { run_.advance(seconds); }

  /// Sets everything that is displayed of the document and of the run, but rates.
  void fill(ui::App& app, int selected_sensor) const;
  /// Largest pressure of the run so far [Pa].
  [[nodiscard]] double largest_pressure() const { return run_.peaks().largest_pressure(); }
  /// Whether update() will report nothing unless something is requested.
  [[nodiscard]] bool idle() const;
  /// Whether the simulation plays, or will as soon as it executes the latest command.
  [[nodiscard]] bool playing() const { return run_.playback().plays; }
  /// Whether the simulation makes steps by itself.
  [[nodiscard]] bool steps() const { return run_.steps(); }
  [[nodiscard]] bool replaying() const { return run_.replays(); }
  /// Whether the displayed step changes by itself.
  [[nodiscard]] bool moves() const { return run_.moves(); }
  [[nodiscard]] const SimFramePtr& frame() const { return run_.frame(); }
  /// The newest command whose effect is displayed.
  [[nodiscard]] CommandId executed() const { return run_.executed(); }
  /// Whether SIMULATE has something to display: the scene of the document, or a saved step.
  [[nodiscard]] bool shows_scene() const { return run_.scene().is_of_document || run_.scene().is_still; }
  /// The scenario that SIMULATE would run: that of the document, or the last one.
  [[nodiscard]] const Scenario& scenario() const {
    return edits().is_open() ? edits().project()->scenario : run_.scene().scenario;
  }

 private:
  void report(Severity severity, std::string text, ui::Holds holds = ui::Holds::always);
  void accept_result(LoadResult result);
  void accept_document(LoadedDocument document);
  void report_notes(const LoadedDocument& document);
  void show_document(LoadedDocument document);
  void drop_scene();
  void resume_polishing();
  void retain_preview(Severity severity, const std::string& why);
  void accept_replies();
  void accept_event(SimEvent event, const SimFrame& frame);
  void accept_scene(const SimFrame& frame);
  void refuse_scene();
  void report_recording(const RecordingWritten& written);
  void report_saved_scene(const SceneSaved& saved);
  void update_results();
  [[nodiscard]] SendToSimulation sender() {
    return [this](SimCommand command) { run_.send(std::move(command)); };
  }
  void build_with(std::vector<SceneAttachment> attachments);
  [[nodiscard]] bool can_play_or_report();

  bool is_real_time_;
  JobExecutor& executor_;
  FeatureJobs jobs_;  // before the document, whose worker uses the jobs
  Document document_;
  Run run_;
  Handover handover_;
  LeadRequest first_lead_;  // of the scene that is opened next
  SessionEvents events_;    // for the next update()
};

}  // namespace taxel::studio
