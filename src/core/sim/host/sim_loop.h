// A simulation that carries out commands and makes steps when it is called: the simulator with its history and
// recordings. It has no thread and waits for nothing; a host decides when to step, by the pacing that is here as well.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
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

/// Whether steps are made, and how fast.
class PlayState {
 public:
  /// Returns whether the host should make steps.
  [[nodiscard]] bool playing() const { return playing_; }
  /// Returns the requested speed, in multiples of real time.
  [[nodiscard]] double speed() const { return speed_; }
  void set_playing(bool on) { playing_ = on, changed_ = true; }
  /// Sets the speed if `factor` is positive and finite.
  void set_speed(double factor);
  /// Returns once whether playing or the speed was set since the last call, so that the host restarts its clock.
  [[nodiscard]] bool consume_change() { return std::exchange(changed_, false); }

 private:
  bool playing_ = false, changed_ = false;
  double speed_ = 1.0;
};

/// Events that were not taken, each with the number of the command that causes it.
class EventQueue {
 public:
  /// Sets the command that causes the next events, or 0 for events without a command.
  void set_command(CommandId command) { command_ = command; }
  /// Forgets which warnings were reported: the next scene reports its own.
  void begin_scene() { warned_.clear(); }
  /// Adds an event. A warning is added once per scene.
  void report(SimReport what);

  [[nodiscard]] const std::vector<SimEvent>& all() const { return events_; }
  std::vector<SimEvent> take() { return std::exchange(events_, {}); }

 private:
  std::vector<SimEvent> events_;
  CommandId command_ = 0;
  std::set<std::string> warned_;  // reported warnings of the scene
};

/// The run that is simulated: its recorded steps, and the one of them that is displayed.
struct SimulatedRun {
  std::uint64_t number = 0;  ///< number of started runs
  StepHistory history;
  Trace trace;                             ///< rows for plots
  std::optional<std::uint64_t> displayed;  ///< displayed recorded step, or empty for the latest step
  std::optional<Stop> stop;                ///< the breakpoint at which the latest step stopped
  std::string error;                       ///< why the simulation failed, or empty
};

/// The rows for plots and timeline as frames share them.
struct CopiedRows {
  std::shared_ptr<const Trace> trace = std::make_shared<const Trace>();
  std::shared_ptr<const HistoryLanes> lanes = std::make_shared<const HistoryLanes>();
  double copied_at = 0;  ///< time of the latest copy [s]
};

/// The wall times of steps.
struct StepTimes {
  StepTime step, record;
  StepCosts costs;
};

/// One simulation with everything that its commands change. Belongs to one thread.
struct SimLoop {
  SimLoop() = default;
  SimLoop(const SimLoop&) = delete;

  std::unique_ptr<Simulator> simulator;  ///< the loaded scene, or null before the first one
  SimulatedRun run;
  PlayState play;
  EventQueue events;
  SimRecordings recordings{[this](SimReport what) { events.report(std::move(what)); }};
  bool follows_before = false;  ///< frames have the previous step
  StepTimes times;
  FrameMemory memory;
  CopiedRows rows;
  SimState state;  ///< scratch
  StepView view;   ///< scratch; the latest step
};

/// Carries out a command, which causes at least one event. A QuitCommand does nothing: the host ends. This function and
/// the two below do not throw: events report errors.
void carry_out(SimLoop& loop, CommandId id, const SimCommand& command);
/// Makes one step and records it. Stops playing at the end of the scenario, at a breakpoint, or when the simulation
/// fails. Returns whether another step can be made.
bool make_step(SimLoop& loop);
/// Makes a frame of the displayed step, at the host's time `now` [s], which includes the effect of the events that were
/// not taken. Rows of plots and timeline are copied at most 30 times per second, or always if `all_rows`. `previous`
/// requests the previous step for a FollowStepBeforeCommand. Adds an event for each new warning of the sensors.
[[nodiscard]] std::shared_ptr<SimFrame> make_frame(SimLoop& loop, double now, bool all_rows, bool previous);

}  // namespace taxel
