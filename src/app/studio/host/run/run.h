// The simulation of the window: the scene that runs, the scene that is being built, and the recorded steps.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/host/document/document.h"
#include "app/studio/host/document/documents.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/run/history/replay.h"
#include "core/sim/host/sim_host.h"

namespace taxel::studio {

/// The requested state, which the simulation may not have reached yet.
struct Playback {
  bool plays = false;     ///< the simulation plays, or will when it carries out `command`
  bool is_held = false;   ///< the run and its single steps wait for polished samples
  int held_steps = 0;     ///< number of single steps that wait
  bool rests = false;     ///< the run was paused by rest_behind_dialog()
  double speed = 1;       ///< multiples of real time
  CommandId command = 0;  ///< the latest command that plays or pauses

  /// Whether the simulation makes steps by itself.
  [[nodiscard]] bool makes_steps() const { return plays && !is_held; }
  /// Whether the user wants the run to go on, now or after a dialog.
  [[nodiscard]] bool goes_on() const { return plays || rests; }
  /// Whether a run waits for release_hold().
  [[nodiscard]] bool holds_run() const { return plays && is_held; }
};

/// The largest reading of each taxel and the largest pressure of a run.
class Peaks {
 public:
  /// Adds the readings of a step and of the rows before it. Another edition of the trace starts again.
  void add(const SimFrame& frame);
  /// Returns the largest pressure of all sensors [Pa].
  [[nodiscard]] double largest_pressure() const { return largest_pressure_; }
  /// Returns the largest readings of all sensors, one sensor after the other [Pa].
  [[nodiscard]] const std::vector<double>& all() const { return peaks_; }
  /// Returns the largest readings of one sensor, one per taxel [Pa]; empty if the frame has no such sensor.
  [[nodiscard]] std::vector<double> of_sensor(const SimFrame& frame, int sensor) const;

 private:
  void raise(const std::vector<double>& readings);

  std::vector<double> peaks_;  // of all sensors, one after the other [Pa]
  double largest_pressure_ = 0;
  std::size_t rows_ = 0;       // number of added rows of the trace
  std::uint64_t edition_ = 0;  // Trace::edition of the peaks
};

struct HistoryCursor {
  Replay replay;
  std::optional<StepRange> loop;  ///< steps that a replay repeats; a replay without a loop stops at the end
  std::uint64_t requested = 0;    ///< step that `command` displays
  CommandId command = 0;          ///< the latest command that displays a recorded step

  [[nodiscard]] bool replays() const { return replay.direction() != 0; }
  /// Returns the displayed step, or the requested one if its command is not carried out yet.
  [[nodiscard]] std::uint64_t step(CommandId carried_out, const SimFrame& frame) const {
    return carried_out < command ? requested : frame.step;
  }
  /// Returns the part of the loop that is recorded, or all recorded steps without a loop.
  [[nodiscard]] StepRange range_in(const HistoryState& history) const {
    StepRange range{history.first, history.last};
    if (!loop) return range;
    return {std::clamp(loop->first, range.first, range.last), std::clamp(loop->last, range.first, range.last)};
  }
};

/// The scene of the simulation.
struct RunningScene {
  Scenario scenario;                      ///< the scenario that runs, or the last one
  bool is_loaded = false;                 ///< the simulation has the scene; frames of earlier scenes are not displayed
  bool is_scenario = false;               ///< the scene is built around the document for `scenario`
  bool is_of_document = false;            ///< the scene is the open document's
  bool is_still = false;                  ///< a recorded step is displayed, without a simulation
  std::vector<SceneAttachment> attached;  ///< layouts on geoms that the file does not declare, or edited ones
  LeadRequest lead;                       ///< start and files that lead the scene

  /// Whether SIMULATE has something to display: the scene of the document, or a saved step.
  [[nodiscard]] bool is_shown() const { return is_of_document || is_still; }
};

/// A scene that the simulation builds. The previous one stays until it is loaded.
struct PendingScene {
  LoadedDocument document;
  bool is_scenario = false;  ///< false if the document is a scene
  Scenario scenario = {};
  std::vector<SceneAttachment> attachments = {};
  LeadRequest lead = {};
  bool plays = false;             ///< the run starts when the scene is loaded
  bool turns_cameras = true;      ///< the cameras turn to the scene
  bool another_document = false;  ///< the document is not the open one
  bool is_shown = true;           ///< SIMULATE is displayed when the scene is loaded
  bool keeps_controls = false;    ///< actuators start with the present controls
  CommandId command = 0;          ///< command that loads the scene
  std::chrono::steady_clock::time_point requested_at = std::chrono::steady_clock::now();
};

/// The simulation of the window with its newest frame. The functions below send the commands of the user to it.
struct Run {
  explicit Run(std::unique_ptr<SimHost> host) : simulation(std::move(host)) {}

  std::unique_ptr<SimHost> simulation;
  SimFramePtr frame;          ///< the displayed frame, or null
  CommandId carried_out = 0;  ///< the newest command that was carried out
  RunningScene scene;         ///< its scenario stays for documents that have none
  std::optional<PendingScene> pending;
  Playback playback;
  HistoryCursor cursor;
  Peaks peaks;

  /// Whether there is a simulation to play.
  [[nodiscard]] bool can_play() const { return frame && !scene.is_still; }
  /// Whether the displayed step changes by itself.
  [[nodiscard]] bool moves() const { return (playback.plays && !(frame && frame->finished)) || cursor.replays(); }
};

void build_scene(Run& run, PendingScene pending);
/// Returns the scene that was loaded, which is the running one from now on. It is held until release_hold().
PendingScene accept_pending(Run& run);
/// Pauses, and displays nothing until another scene is loaded.
void drop_scene(Run& run);
/// Displays a saved step, without a simulation.
void show_saved_step(Run& run, SimFramePtr frame);

/// The functions up to replay() need can_play(). If `holds`, the run or the step waits for release_hold().
void set_playing(Run& run, bool plays, bool holds);
/// Pauses a run while a modal dialog is open. Afterwards the run goes on, unless the answer to the dialog pauses it.
void rest_behind_dialog(Run& run, bool is_dialog_open, bool holds);
void step_by(Run& run, int steps, bool holds);
void reset_run(Run& run);
void scrub(Run& run, std::uint64_t step);
void replay(Run& run, int direction);  ///< plays recorded steps; 0 stops

void set_speed(Run& run, double factor);
/// Pauses, and makes steps at once, up to the end of the run. Only the last one is displayed.
void step_ahead(Run& run, int steps);
void load_keyframe(Run& run, const LoadKeyframeCommand& command);
void release_hold(Run& run);
/// Reports the time that has passed [s].
void advance_run(Run& run, double seconds);

/// Records the reply to a command. Has to be called with each event of the simulation, before accept_frame().
void accept_reply(Run& run, const SimEvent& event);
/// Returns whether the frame is displayed from now on.
bool accept_frame(Run& run, SimFramePtr frame);

/// Returns the attachments of the running scene with the newest model of the edited layout of the scene. A layout
/// without taxels, and one that cannot be simulated, is on no geom that the scene's file does not give it.
std::vector<SceneAttachment> attachments_with_edits(const Run& run, const Document& document);
/// Returns whether the file of the scene declares the sensor on a geom.
bool is_declared(const Run& run, const std::string& geom);
/// Compiles the open scene again with other attachments. The document, the cameras, the controls of actuators and pause
/// stay, and another run begins. Does nothing while a scene is built.
void build_scene_again(Run& run, const Document& document, std::vector<SceneAttachment> attachments,
                       bool is_shown = true);

/// Makes the simulation read by the newest model of the document.
class Handover {
 public:
  Handover(Document& document, Run& run) : document_(document), run_(run) {}

  /// Requests that the simulation reads by the newest model as soon as it is built.
  void request() { is_wanted_ = true; }
  /// Forgets the request, because another document is open.
  void forget_request() { is_wanted_ = false; }
  /// Forgets everything, because the document is closed.
  void clear() { replacement_.reset(); }
  /// Hands over polished samples of the displayed layout.
  void begin(Polished models) { replacement_ = Replacement{std::move(models)}; }
  /// Sends the newest model to the simulation, if it is requested and built.
  void update(HostEvents& events);
  /// Handles the reply to the command that replaces a model.
  void accept(const SimEvent& event, HostEvents& events);

  [[nodiscard]] bool is_replacing() const { return replacement_.has_value(); }
  /// Whether the simulation is to read by a newer model as soon as that is built.
  [[nodiscard]] bool is_requested() const { return is_wanted_; }
  /// Whether the simulation reads by a preview's samples that will be replaced. When they are replaced depends on the
  /// load of the machine, so that a step before would read differently from one start to the next.
  [[nodiscard]] bool will_change_samples() const;

 private:
  /// Samples on their way to the view: the simulation reads by them first.
  struct Replacement {
    Polished models;
    CommandId command = 0;  // command that replaces the model, or 0 before it is sent
  };
  void send_newest(HostEvents& events);
  void send_newest_of_scene(const SensorModelPtr& model, HostEvents& events);
  void send_replacement(HostEvents& events);

  Document& document_;
  Run& run_;
  bool is_wanted_ = false;
  std::optional<Replacement> replacement_;
};

}  // namespace taxel::studio
