// A simulation that executes commands and makes steps when it is called: the simulator with its history and recordings.
// It has no thread and waits for nothing; a host decides when to step.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/history/step_history.h"
#include "core/sim/host/frame_memory.h"
#include "core/sim/host/sim_recordings.h"
#include "core/sim/host/step_time.h"
#include "core/sim/simulator.h"

namespace taxel {

/// One simulation. Belongs to one thread. No function throws: events report errors.
class SimLoop {
 public:
  SimLoop();
  SimLoop(const SimLoop&) = delete;
  SimLoop& operator=(const SimLoop&) = delete;

  /// Executes a command, which causes at least one event. A QuitCommand does nothing: the host ends.
  void execute(CommandId id, const SimCommand& command);
  /// Makes one step and records it. Stops playing at the end of the scenario, at a breakpoint, or when the simulation
  /// fails. Returns whether another step can be made.
  bool step();

  /// Returns whether the host should make steps.
  [[nodiscard]] bool playing() const { return playing_; }
  /// Returns the requested speed, in multiples of real time.
  [[nodiscard]] double speed() const { return speed_; }
  /// Returns the simulated time per step [s]. Needs a scene, which playing() implies.
  [[nodiscard]] double timestep() const { return simulator_->scene()->timestep; }
  /// Returns once whether playing or the speed was set since the last call, so that the host restarts its clock.
  [[nodiscard]] bool consume_pace_change() { return std::exchange(pace_changed_, false); }

  /// Makes a frame of the displayed step, at the host's time `now` [s]. Rows of plots and timeline are copied at most
  /// 30 times per second, or always if `all_rows`. `previous` requests the previous step for a FollowStepBeforeCommand.
  /// Adds an event for each new warning of the sensors.
  [[nodiscard]] std::shared_ptr<SimFrame> make_frame(double now, bool all_rows, bool previous);
  /// Events that were not taken. A frame that is made now includes their effect.
  [[nodiscard]] const std::vector<SimEvent>& events() const { return events_; }
  std::vector<SimEvent> take_events() { return std::exchange(events_, {}); }

  [[nodiscard]] SimRecordings& recordings() { return recordings_; }

 private:
  /// The rows for plots and timeline, with the copies that frames share.
  struct Rows {
    Trace trace;
    std::shared_ptr<const Trace> copied_trace = std::make_shared<const Trace>();
    std::shared_ptr<const HistoryLanes> lanes = std::make_shared<const HistoryLanes>();
    double copied_at = 0;  // [s]
  };
  struct Times {
    StepTime step, record;
    StepCosts costs;
  };

  void run(const PlayCommand& command);
  void run(const PauseCommand& command);
  void run(const StepCommand& command);
  void run(const ResetCommand& command);
  void run(const SpeedCommand& command);
  void run(const LoadScenarioCommand& command);
  void run(const ReplaceModelCommand& command);
  void run(const LoadSceneCommand& command);
  void run(const SaveSceneCommand& command);
  void run(const ScrubCommand& command);
  void run(const FollowStepBeforeCommand& command);
  void run(const RecallCommand& command);
  void run(const BreakpointsCommand& command);
  void run(const StepHistoryLimitsCommand& command);
  void run(const EditSceneCommand& command);
  void run(const LoadKeyframeCommand& command);
  void run(const RecordCommand& command);
  void run(const EndRecordingCommand& command);
  void run(const WriteRecordingCommand& command);
  void run(const ExportHistoryCommand& command);
  void run(const QuitCommand& command);

  void report(SimReport what);
  void fail(const std::string& why);
  void set_playing(bool on);
  void begin_run();
  void rewind();
  void load(const std::function<std::unique_ptr<Simulator>()>& make);
  void resume_from_displayed_step();
  void make_step();
  void add_trace_row();
  void copy_rows(double now, bool all_rows);
  [[nodiscard]] StepPtr previous_step() const;

  std::unique_ptr<Simulator> simulator_;  // null before the first scene
  StepHistory history_;
  SimRecordings recordings_;
  bool playing_ = false, pace_changed_ = false;
  double speed_ = 1.0;
  std::string error_;                       // why the simulation failed
  std::uint64_t runs_ = 0;                  // number of started runs
  CommandId executed_ = 0;                  // command that is being executed, or 0
  std::vector<SimEvent> events_;            // not taken yet
  std::set<std::string> warned_;            // reported warnings of the scene
  std::optional<std::uint64_t> displayed_;  // number of the recorded step that is displayed
  bool follows_before_ = false;             // frames have the previous step
  std::optional<Stop> stop_;
  SimState state_;  // scratch
  StepView view_;   // scratch; the latest step
  Rows rows_;
  Times times_;
  FrameMemory memory_;
};

}  // namespace taxel
