// A simulation that carries out commands and makes steps when it is called: the simulator with its history and
// recordings. It has no thread and waits for nothing; a host decides when to step, by the pacing that is here as well.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/buffer_pool.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/history/step_history.h"
#include "core/sim/host/sim_recordings.h"
#include "core/sim/simulator.h"

namespace taxel {

/// The pace of a simulation: keeps simulated time in step with a clock, at a requested speed. Callers pass the time of
/// the clock [s].
class Pacing {
 public:
  /// Restarts: from `now` on, simulated time runs at `speed` times the clock.
  void restart(double now, double speed) {
    begin_ = now;
    speed_ = speed;
    simulated_ = 0;
    history_.clear();
    history_.push_back({now, 0.0});
  }

  /// Registers a step of length `timestep`. A simulation that is too slow does not catch up later: a lag beyond kMaxLag
  /// is ignored.
  void advance(double timestep, double now) {
    simulated_ += timestep;
    const double behind = (now - begin_) - simulated_ / speed_;
    if (behind > kMaxLag) begin_ += behind - kMaxLag;
    history_.push_back({now, simulated_});
    while (history_.size() > 2 && now - history_.front().clock > kWindow) history_.pop_front();
  }

  /// Returns the time until the next step is due [s]; 0 or less if the step is due.
  [[nodiscard]] double wait(double now) const { return begin_ + simulated_ / speed_ - now; }

  /// Returns the simulated time divided by the real time, over the last kWindow seconds.
  [[nodiscard]] double measured_speed(double now) const {
    if (history_.empty() || !(now > history_.front().clock)) return 0.0;
    return (simulated_ - history_.front().simulated) / (now - history_.front().clock);
  }

 private:
  static constexpr double kMaxLag = 0.05;  // [s]
  static constexpr double kWindow = 0.5;   // [s]
  struct Mark {
    double clock = 0, simulated = 0;
  };
  double begin_ = 0, speed_ = 1, simulated_ = 0;
  std::deque<Mark> history_;
};

/// When frames are due: at most one each `interval`, and that many on average, although they are made somewhat late.
class FrameSchedule {
 public:
  explicit FrameSchedule(double interval) : interval_(interval) {}

  [[nodiscard]] bool is_due(double now) const { return now >= due_; }

  /// Registers a frame made at `now`. The next one is due one interval after this one was, or, if this one is late by
  /// more than an interval or was not due, after `now`.
  void made(double now) {
    const bool in_time = is_due(now) && now - due_ < interval_;
    due_ = (in_time ? due_ : now) + interval_;
  }

 private:
  double interval_;
  double due_ = 0;  // [s] time of the clock at which the next frame is due
};

/// The mean wall time of the latest kSteps steps.
class StepTime {
 public:
  using Duration = std::chrono::nanoseconds;  // whole numbers: the running sum stays exact

  void add(Duration step) {
    sum_ += step - latest_[next_];
    latest_[next_] = step;
    next_ = (next_ + 1) % kSteps;
    if (count_ < kSteps) ++count_;
  }

  /// Returns the mean [s]; 0 before the first step.
  [[nodiscard]] double mean_seconds() const {
    return count_ == 0 ? 0.0 : 1e-9 * static_cast<double>(sum_.count()) / static_cast<double>(count_);
  }

 private:
  static constexpr std::size_t kSteps = 256;  // long enough to read, short enough to follow a change of contact
  std::array<Duration, kSteps> latest_{};
  Duration sum_{0};
  std::size_t next_ = 0, count_ = 0;
};

/// Makes frames. Their memory is reused when a frame is no longer used, so that making a frame costs only its copies.
/// Any thread may release a frame last, also after this object is destroyed.
class FrameMemory {
 public:
  /// Returns a frame with a recorded step, or with the latest step of a simulator. All values that
  /// StepHistory::fill_step() or Simulator::fill_frame() do not set are as in a new frame.
  [[nodiscard]] std::shared_ptr<SimFrame> recorded_frame(const StepHistory& history, std::uint64_t step);
  [[nodiscard]] std::shared_ptr<SimFrame> frame_of(const Simulator& simulator);
  /// Returns a copy. If the reused memory has an earlier copy of the same edition, only new rows are copied.
  [[nodiscard]] std::shared_ptr<const Trace> copy_of(const Trace& trace);
  [[nodiscard]] std::shared_ptr<const HistoryLanes> lanes_of(const StepHistory& history);

 private:
  struct Frame {
    std::vector<Pose> geom_poses;
    std::vector<SensorStep> sensors;
    FilledHits hits;
  };
  template <class Fill>
  std::shared_ptr<SimFrame> make_frame(const Fill& fill);

  std::shared_ptr<BufferPool<Frame>> frames_ = std::make_shared<BufferPool<Frame>>();
  std::shared_ptr<BufferPool<Trace>> traces_ = std::make_shared<BufferPool<Trace>>();
  std::shared_ptr<BufferPool<HistoryLanes>> lanes_ = std::make_shared<BufferPool<HistoryLanes>>();
};

/// One simulation. Belongs to one thread. No function throws: events report errors.
class SimLoop {
 public:
  SimLoop();
  SimLoop(const SimLoop&) = delete;
  SimLoop& operator=(const SimLoop&) = delete;

  /// Carries out a command, which causes at least one event. A QuitCommand does nothing: the host ends.
  void carry_out(CommandId id, const SimCommand& command);
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
  CommandId current_command_ = 0;           // command that is being carried out, or 0
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
