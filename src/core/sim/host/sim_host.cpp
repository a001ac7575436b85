#include "core/sim/host/sim_host.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "core/run/event.h"
#include "core/sim/host/sim_loop.h"

namespace taxel {

/// A newer frame replaces one that was not taken; events are kept until they are taken.
class ReplyBox {
 public:
  void post(SimFramePtr frame, std::vector<SimEvent> events) {
    const std::scoped_lock lock(mutex_);
    replies_.frame.swap(frame);  // the old frame is destroyed outside of the lock
    std::move(events.begin(), events.end(), std::back_inserter(replies_.events));
  }
  SimReplies take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(replies_, {});
  }
  [[nodiscard]] bool has_frame() const {
    const std::scoped_lock lock(mutex_);
    return replies_.frame != nullptr;
  }

 private:
  mutable std::mutex mutex_;
  SimReplies replies_;
};

namespace {

constexpr double kFrameInterval = 1.0 / 60.0;  // [s] time between frames while playing
constexpr double kUnconsumed = 0.25;           // [s] time for which frames are made that nobody consumes
constexpr double kBurst = 0.005;               // [s] time of stepping before commands are checked
constexpr double kNap = 0.002;                 // [s] shortest wait for the clock; several steps may then be due

double seconds_since_epoch() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

/// The mutex guards the members above it. The members below it belong to the simulation's thread, except the box.
struct SimThread::Impl {
  struct PostedCommand {
    CommandId id = 0;
    SimCommand command;
  };
  std::vector<PostedCommand> queue;
  CommandId posted = 0;
  std::string journal_folder;  // empty if recordings are in memory only
  std::mutex mutex;
  std::condition_variable wake;

  ReplyBox box;

  SimLoop loop;
  Pacing pacing;
  FrameSchedule schedule{kFrameInterval};
  double last_consumed = 0;
  bool answered = true;  // the latest frame followed a command, or is the last one of a run
  bool changed = true;   // the state has changed since the latest frame

  std::thread thread;  // last member: starts after all others exist

  Impl() : thread([this] { run(); }) {}
  ~Impl() {
    post(QuitCommand{});
    thread.join();
  }

  CommandId post(SimCommand command) {
    CommandId id = 0;
    {
      const std::scoped_lock lock(mutex);
      id = ++posted;
      queue.push_back({id, std::move(command)});
    }
    wake.notify_one();
    return id;
  }

  void run();
  std::vector<PostedCommand> take_commands();
  void play();
  void restart_pacing() { pacing.restart(seconds_since_epoch(), loop.play.speed()); }
  bool frames_are_consumed(double now);
  void publish(bool even_if_recent);
};

/// Waits until there are commands, or the next step is due, and returns the commands.
std::vector<SimThread::Impl::PostedCommand> SimThread::Impl::take_commands() {
  std::unique_lock lock(mutex);
  const auto something = [this] { return !queue.empty(); };
  if (!loop.play.playing()) {
    wake.wait(lock, something);
  } else {
    const double rest = pacing.wait(seconds_since_epoch());
    if (rest > 0) wake.wait_for(lock, std::chrono::duration<double>(std::clamp(rest, kNap, kFrameInterval)), something);
  }
  loop.recordings.set_journal_folder(journal_folder);
  return std::exchange(queue, {});
}

void SimThread::Impl::run() {
  while (true) {
    for (const auto& [id, command] : take_commands()) {
      if (std::holds_alternative<QuitCommand>(command)) return;
      carry_out(loop, id, command);
      if (loop.play.consume_change()) restart_pacing();
      changed = true;
      publish(true);
    }
    if (!loop.play.playing()) continue;
    play();
    publish(!loop.play.playing());
  }
}

/// Makes steps until simulated time reaches the clock, or kBurst has passed.
void SimThread::Impl::play() {
  const double begin = seconds_since_epoch();
  while (loop.play.playing()) {
    const double now = seconds_since_epoch();
    if (pacing.wait(now) > 0 || now - begin > kBurst) return;
    const bool can_continue = make_step(loop);
    changed = true;
    if (loop.play.consume_change()) restart_pacing();
    if (!can_continue) return;
    pacing.advance(loop.simulator->scene()->timestep, seconds_since_epoch());
  }
}

/// Returns whether frames are consumed while the simulation plays: a window that is not drawn must cost nothing. A
/// frame that followed a command does not count, because it is always consumed.
bool SimThread::Impl::frames_are_consumed(double now) {
  if (box.has_frame()) return now - last_consumed < kUnconsumed;
  if (!answered) last_consumed = now;
  return true;
}

/// Publishes a frame if the state has changed, the schedule demands one and frames are consumed, or always if
/// `even_if_recent`.
void SimThread::Impl::publish(bool even_if_recent) {
  const double now = seconds_since_epoch();
  if (!changed) return;
  if (!even_if_recent && (!schedule.is_due(now) || !frames_are_consumed(now))) return;
  const std::shared_ptr<SimFrame> frame = make_frame(loop, now, even_if_recent, !loop.play.playing());
  frame->measured_speed = loop.play.playing() ? pacing.measured_speed(now) : 0.0;
  box.post(frame, loop.events.take());
  schedule.made(now);
  answered = even_if_recent;
  changed = false;
}

SimThread::SimThread() : impl_(std::make_unique<Impl>()) {}
SimThread::~SimThread() = default;

CommandId SimThread::send(SimCommand command) {
  return impl_->post(std::move(command));
}

void SimThread::advance(double /*seconds*/) {}

SimReplies SimThread::take() {
  return impl_->box.take();
}

void SimThread::set_journal_folder(const std::string& folder) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->journal_folder = folder;
}

namespace {

/// A number of steps that is less than a whole one by this fraction is whole: 20 ms are twenty steps of 1 ms.
constexpr double kRounding = 1e-12;

bool sets_pace(const SimCommand& command) {
  return std::holds_alternative<PlayCommand>(command) || std::holds_alternative<PauseCommand>(command) ||
         std::holds_alternative<SpeedCommand>(command);
}

}  // namespace

InlineSim::InlineSim() : loop_(std::make_unique<SimLoop>()) {}
InlineSim::~InlineSim() = default;

void InlineSim::set_journal_folder(const std::string& folder) {
  loop_->recordings.set_journal_folder(folder);
}

CommandId InlineSim::send(SimCommand command) {
  carry_out(*loop_, ++sent_, command);
  const SimReport& newest = loop_->events.all().back().what;
  if (std::holds_alternative<RunStarted>(newest) || std::holds_alternative<SceneLoaded>(newest) ||
      std::holds_alternative<ScrubCommand>(command))
    unspent_ = 0;
  is_held_ = is_held_ || !sets_pace(command) || !std::holds_alternative<Done>(newest);
  is_frame_due_ = true;
  return sent_;
}

void InlineSim::advance(double seconds) {
  if (is_held_ || !loop_->play.playing()) return;
  unspent_ += seconds * loop_->play.speed();
  const auto steps = static_cast<int>(std::floor(unspent_ / loop_->simulator->scene()->timestep * (1 + kRounding)));
  if (steps < 1) return;
  unspent_ -= steps * loop_->simulator->scene()->timestep;
  for (int i = 0; i < steps && make_step(*loop_); ++i) {
  }
  is_held_ = is_frame_due_ = true;
}

SimReplies InlineSim::take() {
  SimReplies replies;
  if (is_frame_due_) replies.frame = make_frame(*loop_, 0, true, true);
  replies.events = loop_->events.take();
  is_held_ = is_frame_due_ = false;
  return replies;
}

}  // namespace taxel
