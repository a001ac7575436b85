#include "core/sim/sim_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/mailbox.h"
#include "core/sim/history/step_history.h"
#include "core/sim/pacing.h"
#include "core/sim/simulator.h"
#include "core/sim/step_time.h"

namespace taxel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since_epoch() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

constexpr double kFrameInterval = 1.0 / 60.0;  // [s] at most so many frames while playing
constexpr double kTraceInterval = 1.0 / 30.0;  // [s] at most so many copies of the trace
constexpr double kBurst = 0.005;               // [s] of stepping before commands are looked at again
constexpr double kNap = 0.002;                 // [s] shortest wait for the clock: several steps are then due at once
constexpr std::size_t kEndlessRows = 10000;    // rows kept, at least, of a scene that has no end

}  // namespace

/// Everything but the queue and the mailbox belongs to the simulation's thread.
struct SimThread::Impl {
  std::mutex mutex;  // guards the next five
  std::condition_variable wake;
  std::vector<SimCommand> queue;
  std::uint64_t posted = 0;
  bool clock_driven = true;
  bool clock_changed = false;

  Mailbox<SimFrame> mailbox;

  std::unique_ptr<Simulator> simulator;
  Pacing pacing;
  bool running = true, playing = false, by_clock = true;
  double speed = 1.0;
  std::string error;    // why stepping stopped
  std::string refused;  // why the last scene or model was not taken; the one before goes on
  std::uint64_t loads = 0, replacements = 0, runs = 0, commands = 0;
  SavedScene saved;
  StepHistory history;
  std::optional<std::uint64_t> scrubbed;  // the step of the past that is shown
  bool follows_before = false;            // frames carry the step before
  std::optional<Jump> stop;
  SimState state;  // scratch
  std::shared_ptr<const HistoryLanes> lanes = std::make_shared<const HistoryLanes>();
  std::vector<TraceRow> rows;
  std::shared_ptr<const std::vector<TraceRow>> trace = std::make_shared<const std::vector<TraceRow>>();
  StepTime step_time, record_time;
  double last_frame = 0, last_trace = 0;
  bool changed = true;  // something to show since the last frame

  std::thread thread;  // last: starts when all else is there

  Impl() : thread([this] { run(); }) {}
  ~Impl() {
    post(QuitCommand{});
    thread.join();
  }

  std::uint64_t post(SimCommand command) {
    std::uint64_t number = 0;
    {
      const std::scoped_lock lock(mutex);
      queue.push_back(std::move(command));
      number = ++posted;
    }
    wake.notify_one();
    return number;
  }

  void run();
  std::vector<SimCommand> take_commands();
  void execute(const SimCommand& command);
  void load(const std::function<std::unique_ptr<Simulator>()>& make);
  void replace_model(const ReplaceModelCommand& command);
  void set_playing(bool on);
  void begin_run();
  void go_on_from_shown();
  void scrub(std::uint64_t step);
  bool execute_on_scene(const SimCommand& command);
  void execute_on_history(const SimCommand& command);
  bool step_once();
  void add_trace_row();
  void burst();
  void publish(bool even_if_recent);
  void copy_rows(double now, bool even_if_recent);
  [[nodiscard]] std::shared_ptr<const StepBefore> step_before() const;

  [[nodiscard]] bool stepping() const { return playing && by_clock && simulator != nullptr; }
};

std::vector<SimCommand> SimThread::Impl::take_commands() {
  std::unique_lock lock(mutex);
  const auto something = [this] { return !queue.empty() || clock_changed; };
  if (!stepping()) {
    wake.wait(lock, something);
  } else {
    const double rest = pacing.wait(seconds_since_epoch());
    if (rest > 0) wake.wait_for(lock, std::chrono::duration<double>(std::clamp(rest, kNap, kFrameInterval)), something);
  }
  if (clock_changed) {
    by_clock = clock_driven;
    clock_changed = false;
    pacing.restart(seconds_since_epoch(), speed);
  }
  std::vector<SimCommand> taken;
  taken.swap(queue);
  return taken;
}

void SimThread::Impl::run() {
  while (running) {
    for (const SimCommand& command : take_commands()) {
      try {
        execute(command);
      } catch (const std::exception& e) {
        error = e.what();
        set_playing(false);
      }
      changed = true;
      ++commands;
      if (!running) return;
      publish(true);
    }
    if (!stepping()) continue;
    burst();
    publish(!playing);
  }
}

/// Steps until the clock is reached, commands wait, or it is time for a frame.
void SimThread::Impl::burst() {
  const double begin = seconds_since_epoch();
  while (stepping()) {
    const double now = seconds_since_epoch();
    if (pacing.wait(now) > 0 || now - begin > kBurst) return;
    if (!step_once()) return;
    pacing.advance(simulator->scene()->timestep, seconds_since_epoch());
  }
}

/// One step with its row. Stops playing at the end of the scenario, or when the simulation fails. Returns whether it
/// may go on.
bool SimThread::Impl::step_once() {
  if (simulator != nullptr && error.empty()) go_on_from_shown();
  if (simulator == nullptr || simulator->finished() || !error.empty()) {
    set_playing(false);
    return false;
  }
  stop.reset();
  try {
    const Clock::time_point begin = Clock::now();
    simulator->step();
    const Clock::time_point stepped = Clock::now();
    simulator->save_state(state);
    stop = history.record(simulator->view(), state);
    record_time.add(Clock::now() - stepped);
    step_time.add(Clock::now() - begin);
  } catch (const std::exception& e) {  // what was computed of this step is no step: the one before is shown
    error = e.what();
    set_playing(false);
    if (!history.empty()) scrubbed = history.last();
    return false;
  }
  changed = true;
  if (simulator->row_due()) add_trace_row();
  if (simulator->finished() || stop) set_playing(false);
  return !simulator->finished() && !stop;
}

void SimThread::Impl::add_trace_row() {
  const SimRow row = simulator->row();
  TraceRow traced{row.time, row.travel, {}};
  for (const SensorModelPtr& sensor : simulator->scene()->sensors)
    if (sensor && sensor->quality == SampleQuality::preview) traced.quality = SampleQuality::preview;
  for (const std::vector<double>& readings : row.readings)
    traced.readings.insert(traced.readings.end(), readings.begin(), readings.end());
  rows.push_back(std::move(traced));
  if (simulator->scene()->duration == 0 && rows.size() >= 2 * kEndlessRows)
    rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kEndlessRows));
}

/// At its start: the history begins with what is there before the first step.
void SimThread::Impl::begin_run() {
  ++runs;
  error.clear();
  rows.clear();
  scrubbed.reset();
  stop.reset();
  history.clear();
  if (simulator == nullptr) return;
  simulator->save_state(state);
  history.record(simulator->view(), state);
}

/// The simulation goes back to the step that is shown, and what came after it has not been.
void SimThread::Impl::go_on_from_shown() {
  if (!scrubbed) return;
  const SimState& from = history.state(*scrubbed);
  simulator->restore_state(from);
  while (!rows.empty() && rows.back().time > from.time) rows.pop_back();
  history.cut_after(*scrubbed);
  scrubbed.reset();
}

void SimThread::Impl::scrub(std::uint64_t step) {
  if (history.empty()) return;
  set_playing(false);
  scrubbed = std::clamp(step, history.first(), history.last());
  if (*scrubbed == history.last() && error.empty()) scrubbed.reset();  // the newest, which the simulator has
}

void SimThread::Impl::execute_on_history(const SimCommand& command) {
  if (const auto* to = std::get_if<ScrubCommand>(&command)) {
    scrub(to->step);
  } else if (const auto* follow = std::get_if<FollowStepBeforeCommand>(&command)) {
    follows_before = follow->on;
  } else if (const auto* breakpoints = std::get_if<BreakpointsCommand>(&command)) {
    history.set_breakpoints(breakpoints->breakpoints);
  } else if (const auto* limits = std::get_if<StepHistoryLimitsCommand>(&command)) {
    history.set_limits(limits->limits);
    if (scrubbed && !history.contains(*scrubbed)) scrubbed = history.first();
  }
}

/// What a hand sets. Returns whether the command was one of these.
bool SimThread::Impl::execute_on_scene(const SimCommand& command) {
  if (const auto* edit = std::get_if<EditSceneCommand>(&command)) {
    if (simulator != nullptr && !scrubbed && error.empty()) simulator->edit(edit->edit);
  } else if (const auto* key = std::get_if<LoadKeyframeCommand>(&command)) {
    if (simulator != nullptr && simulator->load_keyframe(key->keyframe)) begin_run();
    set_playing(false);
  } else if (const auto* save = std::get_if<SaveSceneCommand>(&command)) {
    saved = {saved.number + 1, save->file, ""};
    try {
      if (simulator == nullptr) throw Error(save->file, "there is no scene to write");
      simulator->save_scene(save->file);
    } catch (const std::exception& e) {
      saved.error = e.what();
    }
  } else {
    return false;
  }
  return true;
}

void SimThread::Impl::set_playing(bool on) {
  playing = on;
  pacing.restart(seconds_since_epoch(), speed);
}

void SimThread::Impl::load(const std::function<std::unique_ptr<Simulator>()>& make) {
  ++loads;
  try {
    simulator = make();
  } catch (const std::exception& e) {
    refused = e.what();
    return;
  }
  refused.clear();
  begin_run();
  step_time = record_time = {};
  pacing.restart(seconds_since_epoch(), speed);
}

void SimThread::Impl::replace_model(const ReplaceModelCommand& command) {
  ++replacements;
  refused.clear();
  try {
    if (simulator == nullptr) return;
    simulator->replace_model(command.replaced, command.model);
    if (error.empty()) history.replace_newest(simulator->view());
  } catch (const std::exception& e) {
    refused = e.what();  // the one before goes on
  }
}

void SimThread::Impl::execute(const SimCommand& command) {
  const auto rewind = [this] {
    if (simulator != nullptr) simulator->reset();
    begin_run();
  };
  if (std::holds_alternative<QuitCommand>(command)) {
    running = false;
  } else if (std::holds_alternative<PlayCommand>(command)) {
    const bool of_the_past = scrubbed && *scrubbed < history.last();
    if (of_the_past) error.clear();  // what went wrong lies after it
    const bool over = simulator != nullptr && simulator->finished() && !of_the_past;
    if (over || !error.empty()) rewind();
    set_playing(simulator != nullptr);
  } else if (std::holds_alternative<PauseCommand>(command)) {
    set_playing(false);
  } else if (std::holds_alternative<ResetCommand>(command)) {
    rewind();
    set_playing(false);
  } else if (const auto* step = std::get_if<StepCommand>(&command)) {
    for (int i = 0; i < step->steps && step_once(); ++i) {
    }
  } else if (const auto* factor = std::get_if<SpeedCommand>(&command)) {
    if (factor->factor > 0 && std::isfinite(factor->factor)) speed = factor->factor;
    pacing.restart(seconds_since_epoch(), speed);
  } else if (const auto* sweep = std::get_if<LoadSweepCommand>(&command)) {
    load([&] { return Simulator::make_sweep(sweep->model, sweep->scenario); });
  } else if (const auto* replace = std::get_if<ReplaceModelCommand>(&command)) {
    replace_model(*replace);
  } else if (const auto* scene = std::get_if<LoadSceneCommand>(&command)) {
    load([&] { return Simulator::load(scene->file, scene->attachments); });
  } else if (!execute_on_scene(command)) {
    execute_on_history(command);
  }
}

/// The rows for plots and timeline, copied only when there are others, and not too often.
void SimThread::Impl::copy_rows(double now, bool even_if_recent) {
  const std::uint64_t last = history.empty() ? 0 : history.last();
  const std::vector<StepMark>& copied = lanes->steps;
  const bool other_steps = copied.size() != history.size() || (!copied.empty() && copied.back().step != last);
  const bool other_rows = trace->size() != rows.size() || rows.empty() || trace->back().time != rows.back().time;
  const bool shrunk = trace->size() > rows.size() || (!copied.empty() && copied.back().step > last);
  if (!shrunk && !even_if_recent && now - last_trace < kTraceInterval) return;
  if (other_rows) trace = std::make_shared<const std::vector<TraceRow>>(rows);
  if (other_steps || even_if_recent) lanes = history.lanes();
  if (other_rows || other_steps) last_trace = now;
}

/// As the history has it.
std::shared_ptr<const StepBefore> SimThread::Impl::step_before() const {
  if (history.empty()) return nullptr;
  const std::uint64_t shown = scrubbed.value_or(history.last());
  if (shown == 0 || !history.contains(shown - 1)) return nullptr;
  SimFrame frame;
  history.fill_frame(shown - 1, frame);
  auto before = std::make_shared<StepBefore>();
  *before = {frame.scene, frame.step, frame.time, std::move(frame.sensors)};
  return before;
}

/// Posts a frame when there is something new, at most every kFrameInterval unless told otherwise.
void SimThread::Impl::publish(bool even_if_recent) {
  const double now = seconds_since_epoch();
  if (!changed || (!even_if_recent && now - last_frame < kFrameInterval)) return;
  copy_rows(now, even_if_recent);
  const auto frame = std::make_shared<SimFrame>();
  frame->scene = frame->simulated = std::make_shared<const SimScene>();
  if (simulator != nullptr) {
    scrubbed ? history.fill_frame(*scrubbed, *frame) : simulator->fill_frame(*frame);
    if (scrubbed) frame->controls = simulator->controls_of(history.state(*scrubbed));
    frame->simulated = simulator->scene();
    frame->warnings = simulator->warnings();
  }
  frame->recorded = scrubbed.has_value();
  frame->history = {history.empty() ? 0 : history.first(),
                    history.empty() ? 0 : history.last(),
                    history.size(),
                    history.bytes(),
                    record_time.mean_seconds(),
                    history.limits(),
                    lanes};
  if (follows_before && !stepping()) frame->before = step_before();
  frame->breakpoints = history.breakpoints();
  frame->stop = stop;
  frame->playing = playing;
  frame->speed = speed;
  frame->measured_speed = playing ? pacing.measured_speed(now) : 0.0;
  frame->step_seconds = step_time.mean_seconds();
  frame->trace = trace;
  frame->runs = runs;
  frame->commands = commands;
  frame->saved = saved;
  frame->loads = loads;
  frame->replacements = replacements;
  frame->failed = !error.empty();
  frame->error = error.empty() ? refused : error;
  mailbox.post(frame);
  last_frame = now;
  changed = false;
}

SimThread::SimThread() : impl_(std::make_unique<Impl>()) {}
SimThread::~SimThread() = default;

std::uint64_t SimThread::send(SimCommand command) {
  return impl_->post(std::move(command));
}

SimFramePtr SimThread::newest_frame() {
  return impl_->mailbox.take();
}

void SimThread::set_clock_driven(bool on) {
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->clock_driven = on;
    impl_->clock_changed = true;
  }
  impl_->wake.notify_one();
}

}  // namespace taxel
