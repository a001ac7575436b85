// The open document and its simulation: what there is to show, without any window.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/app/values/shown.h"
#include "app/studio/document/autosave.h"
#include "app/studio/document/edit_session.h"
#include "app/studio/document/loader.h"
#include "app/studio/features/explain/explain_state.h"
#include "app/studio/features/measure/measure_state.h"
#include "app/studio/features/models/models_state.h"
#include "app/studio/features/study/study_state.h"
#include "app/studio/jobs/feature_jobs.h"
#include "core/run/history/replay.h"
#include "core/sim/host/sim_host.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// What happened since the last look, for the window to act on.
struct SessionNews {
  std::vector<std::pair<Severity, std::string>> messages;
  std::optional<ui::Mode> opened;  ///< another document or scene is shown, best in this mode
  bool another_document = false;   ///< not the same one in another scene
  std::string saved_scene;         ///< file that was written
  std::string unwritten;           ///< why a recording could not be written: it is kept, to be written elsewhere
  std::string saved_state;         ///< of the window, when the step that was opened was saved
  std::string opened_file;         ///< where it came from; empty: built in
  bool framed = false;             ///< the cameras should turn to it (not after a reload)
  bool new_frame = false;
  bool new_model = false;      ///< of what is edited
  bool resized = false;        ///< its mesh has another size: the cameras should turn to it
  bool doubtful_mesh = false;  ///< it was opened alone, or cannot be simulated, and its report is worth a look
  bool reloaded = false;       ///< the document was read again, as an edit
  bool new_reading = false;    ///< of the probe, of the measure, or of the receptive fields
};

class Session {
 public:
  /// by_clock: the simulation follows the clock in its own thread. Else it moves only by advance(), and every request
  /// is answered before the next picture, so that the same requests give the same pictures.
  /// `wake` is called from a worker when update() has something to report.
  Session(JobPool& pool, bool by_clock, std::function<void()> wake);

  /// Empty: the built-in fingertip. `skin`: for a layout of another program.
  void open(const std::string& file, const SkinChoice& skin = {});
  void recover(const LostDocument& lost);  ///< unsaved, as it was when it was kept
  void reload();                           ///< keeps pause, cameras and what undo knows
  void close();
  void cancel_loading() { loader_.cancel(); }  ///< or polishing, whichever runs
  void polish();                               ///< the samples shown, where they are a preview's

  [[nodiscard]] PatternJob& patterns() { return jobs_.patterns; }
  [[nodiscard]] const PatternJob& patterns() const { return jobs_.patterns; }
  /// What is edited. In LAYOUT edits leave the simulation alone.
  [[nodiscard]] EditSession& edits() { return edits_; }
  [[nodiscard]] const EditSession& edits() const { return edits_; }
  /// To be called after each edit. `simulated`: the simulation is looked at, and is to read by it.
  void after_edit(bool simulated);
  /// As soon as the newest model is built, the simulation reads by it.
  void hand_over() { hand_over_wanted_ = true; }
  /// Presses the probe on what is edited, after every edit anew; none: there is no probe.
  void press(std::optional<Probe> probe);
  /// Measures between two points; none: nothing.
  void measure(std::optional<ui::MeasureRequest> request) { jobs_.measure.post(std::move(request)); }
  /// Works out the receptive fields of what this mode shows, for the pictures to come.
  void show_fields(ui::Mode mode, ui::FieldMap map, bool weights) {
    field_mode_ = mode, field_map_ = map, field_weights_ = weights;
  }
  /// Explains a taxel of the simulation in every step that is shown; none: nothing any more.
  void explain(std::optional<ui::ExplainRequest> request);
  /// Reads the recorded steps of the simulation by other models, while it stands; none: not any more.
  void compare_models(std::optional<ui::ModelsRequest> request) { jobs_.models.compare(request); }
  /// Runs a parameter study of what is simulated; none: it is cancelled, and nothing is shown.
  void study(const std::optional<ui::StudyRequest>& request);
  /// From the last edit to the probe's reading [s]; none: not read yet.
  [[nodiscard]] std::optional<double> edit_latency() const { return edit_latency_; }
  void saved_as(const std::string& file);  ///< a project
  /// File of the open document; empty: none, or built in.
  [[nodiscard]] std::string file() const { return document_ ? document_->file : ""; }
  /// Tip and pad of the document are a guess.
  [[nodiscard]] bool frame_is_guess() const { return document_ && document_->frame_is_guess; }
  [[nodiscard]] DocumentKind kind() const { return document_ ? document_->kind : DocumentKind::layout; }

  /// False: there is nothing to simulate, or it cannot be, which is told.
  bool run_scenario(const Scenario& scenario);
  /// The scenario of documents that have none, until another one runs.
  void begin_with(const Scenario& scenario) { scenario_ = scenario; }
  void set_playing(bool playing);
  void step_by(int steps);  ///< through recorded steps, and one more than there are is simulated
  void scrub(std::uint64_t step);
  void replay(int direction);                     ///< of recorded steps; 0 stops it
  void set_loop(std::optional<StepRange> range);  ///< none: a replay stops at the end
  void set_breakpoints(const Breakpoints& breakpoints);
  void set_history_limits(const StepHistoryLimits& limits);
  void reset();
  void set_speed(double factor);
  void send(SimCommand command);  ///< to the running scene: what a hand sets there
  /// A layout on geoms of the open scene, which is compiled anew, paused or running as before.
  void attach(const std::vector<std::string>& geoms, const std::string& layout);
  void detach(const std::string& geom);
  void save_scene(const std::string& file);

  /// Every step is kept from now on, until it is switched off or the run ends; then it is written to `file`.
  void record(bool on, const std::string& file);
  void write_recording(const std::string& file);  ///< that could not be written where it was to be
  /// Rows are kept in journals of this folder while they are recorded.
  void keep_recordings_in(const std::string& folder) { simulation_->set_journal_folder(folder); }
  void export_recording(const std::string& file);  ///< of what is recorded, or of the loop

  /// Takes what worker and simulation have ready. Not by clock it waits for them, but shows a preview for some
  /// pictures, long enough for a script to act on it, unless it is to `hurry`.
  SessionNews update(bool hurry = false);
  /// Runs the simulation for `seconds` of real time, if it plays, and waits for its frame. Not by clock only.
  void advance(double seconds);

  /// Everything of `input` but rates.
  void fill(ui::App& app, int selected_sensor) const;
  [[nodiscard]] double largest_pressure() const { return largest_pressure_; }  ///< of the run so far [Pa]
  [[nodiscard]] bool idle() const {
    return !loader_.busy() && !pending_ && !polished_ && !edits_.building() && !jobs_.busy();
  }
  /// Whether the simulation plays, or will as soon as it executes the latest command.
  [[nodiscard]] bool playing() const { return playing_; }
  /// Whether a run waits until the samples that it reads by are polished.
  [[nodiscard]] bool holds_run() const { return held_ && playing_; }
  /// Whether the simulation makes steps by itself.
  [[nodiscard]] bool steps() const { return playing() && !held_; }
  [[nodiscard]] bool replaying() const { return replay_.direction() != 0; }
  /// Whether one step follows another by itself.
  [[nodiscard]] bool moves() const { return (playing() && !(frame_ && frame_->finished)) || replaying(); }
  [[nodiscard]] const SimFramePtr& frame() const { return frame_; }
  /// The newest command whose effect is displayed.
  [[nodiscard]] CommandId executed() const { return executed_; }
  [[nodiscard]] bool simulates_document() const { return simulates_document_; }
  /// There is something to look at in SIMULATE: the document's scene, or a step that was saved.
  [[nodiscard]] bool shows_scene() const { return simulates_document_ || still_; }
  /// What SIMULATE would run: the document's, else the last one.
  [[nodiscard]] const Scenario& scenario() const { return edits_.is_open() ? edits_.project()->scenario : scenario_; }

 private:
  /// A scene that the simulation was asked to build; what is open stays until it stands.
  struct Pending {
    Document document;
    bool in_scenario = false;  ///< else it is its own scene
    Scenario scenario = {};
    std::vector<SceneAttachment> attachments = {};
    bool play = false, framed = true;
    bool another = false;  ///< not the document that is open
    bool shown = true;     ///< SIMULATE is displayed as soon as the scene is loaded
    CommandId load = 0;    ///< command that loads the scene
    std::chrono::steady_clock::time_point asked = std::chrono::steady_clock::now();
  };

  /// Samples that were polished, on their way to what is shown: the simulation reads by them first.
  struct Replacement {
    Polished models;
    CommandId command = 0;  ///< command that replaces the model, or 0 before it is sent
  };

  void show_document(Document document);
  void restore_origin();
  void take_edited(SessionNews& news);
  void accept_reload(const Document& document, SessionNews& news);
  void take_reading(SessionNews& news);
  void take_fields(SessionNews& news);
  void take_explanation(SessionNews& news);
  void take_models(SessionNews& news);
  void hand_over_newest();
  void accept_result(LoadResult result, SessionNews& news);
  void refuse_pending();
  void resume_polishing();
  void keep_preview(Severity severity, const std::string& why, SessionNews& news);
  void show_polished(SessionNews& news);
  void finish_polished(SessionNews& news);
  [[nodiscard]] bool preview_is_due() const;
  void accept_document(Document document, SessionNews& news);
  void accept_replies(SimReplies replies, SessionNews& news);
  void accept_event(SimEvent event, const SimFrame& frame, SessionNews& news);
  void accept_pending(const SimFrame& frame, SessionNews& news);
  void accept_refusal(CommandId command, const std::string& why, SessionNews& news);
  CommandId tell(SimCommand command) { return simulation_->send(std::move(command)); }
  void send_playing();
  void note_stop();
  void step_once();
  [[nodiscard]] bool samples_will_change() const;
  void start_held_run();
  void show_step(std::uint64_t step);
  [[nodiscard]] std::uint64_t shown_step() const;
  void advance_replay(double seconds);
  void replay_by_clock();
  void tell_stop(const Stopped& stopped, const Breakpoints& breakpoints, SessionNews& news);
  void build_scene(Pending pending);
  void build_with(std::vector<SceneAttachment> attachments);
  void take_sensors(const SimFrame& frame);
  void tell_saved(const SceneSaved& saved, SessionNews& news);
  void tell_written(const RecordingWritten& written, SessionNews& news);
  void drop_scene();
  void show_saved_step();
  [[nodiscard]] bool runs_or_refuses();
  void note_pressures(const SimFrame& frame);

  /// Not by clock: whether the picture to come still shows that a large file is being loaded.
  [[nodiscard]] bool load_is_shown() const { return loader_.loading() && load_pictures_ < load_pictures_due_; }

  bool by_clock_;
  SensorCache cache_;
  Loader loader_;
  FeatureJobs jobs_;
  ui::MeasuredPtr measured_;
  ui::ShownFieldsPtr shown_fields_;
  ui::Mode field_mode_ = ui::Mode::simulate;
  ui::FieldMap field_map_ = ui::FieldMap::none;
  bool field_weights_ = false;
  ui::ComparedPtr compared_;
  std::optional<ui::ExplainRequest> explain_request_;
  ui::ExplainedPtr explained_;
  std::optional<Probe> probe_request_;
  ui::PressedProbePtr pressed_;                                     ///< of the model that is shown
  std::optional<std::chrono::steady_clock::time_point> edited_at_;  ///< and its reading is not shown yet
  std::optional<double> edit_latency_;
  EditSession edits_;
  std::unique_ptr<SimHost> simulation_;
  SimFramePtr frame_;
  bool has_scene_ = false;  ///< the simulation has the scene that was requested; earlier frames are not displayed
  CommandId executed_ = 0;  ///< newest executed command
  std::optional<Pending> pending_;
  std::optional<Replacement> polished_;
  SensorModelPtr left_preview_;                    ///< polishing it was cancelled or failed: not begun again unasked
  int load_pictures_ = 0, load_pictures_due_ = 0;  ///< shown of the present load, and to be; not by clock only
  int preview_pictures_ = 0;                       ///< shown of the present preview; not by clock only
  std::optional<Document> document_;
  std::optional<LostDocument> recovered_;  ///< what is being loaded is this
  std::string refusal_;                    ///< why what was asked for was not done, to be told
  Scenario scenario_;                      ///< that runs, or the last one
  bool still_ = false;                     ///< what is shown is a step that was saved: there is nothing to run
  std::vector<SceneAttachment> attached_;  ///< to the open scene
  bool runs_scenario_ = false, simulates_document_ = false;
  bool playing_ = false, reloading_ = false, hand_over_wanted_ = false;
  bool held_ = false;           ///< runs and steps wait for polished samples
  int held_steps_ = 0;          ///< number of single steps that wait
  CommandId play_command_ = 0;  ///< the last command that plays or pauses
  double speed_ = 1;
  Replay replay_;
  std::optional<StepRange> loop_;
  std::chrono::steady_clock::time_point replayed_at_;
  std::uint64_t scrubbed_to_ = 0;  ///< requested step
  CommandId scrub_command_ = 0;    ///< command that requests the step
  double largest_pressure_ = 0;
  std::vector<double> peaks_;  ///< of all sensors, one after the other [Pa]
  std::size_t rows_seen_ = 0;
  std::uint64_t noted_trace_ = 0;  ///< Trace::edition of the peaks
};

}  // namespace taxel::studio
