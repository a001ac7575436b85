#include "core/sim/host/sim_thread.h"

#include <algorithm>

#include "core/sim/host/sim_thread_impl.h"

namespace taxel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameInterval = 1.0 / 60.0;  // [s] shortest time between frames while playing
constexpr double kUnconsumed = 0.25;           // [s] time for which frames are made that nobody consumes
constexpr double kTraceInterval = 1.0 / 30.0;  // [s] shortest time between copies of the trace
constexpr double kBurst = 0.005;               // [s] time of stepping before commands are checked
constexpr double kNap = 0.002;                 // [s] shortest wait for the clock; several steps may then be due
constexpr std::size_t kEndlessRows = 10000;    // least number of retained rows of a scene without an end

StepCost cost_of(Clock::duration step, Clock::duration history, const SensorTimes& before, const SensorTimes& after) {
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<float>(d).count(); };
  StepCost cost;
  cost.surfaces = static_cast<float>(after.surfaces - before.surfaces);
  cost.forces = static_cast<float>(after.forces - before.forces);
  cost.readings = static_cast<float>(after.readings - before.readings);
  cost.mujoco = std::max(0.0f, seconds(step) - cost.surfaces - cost.forces - cost.readings);
  cost.history = seconds(history);
  return cost;
}

}  // namespace

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
    real_time = clock_driven;
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

/// Makes steps until simulated time reaches the clock, or kBurst has passed.
void SimThread::Impl::burst() {
  const double begin = seconds_since_epoch();
  while (stepping()) {
    const double now = seconds_since_epoch();
    if (pacing.wait(now) > 0 || now - begin > kBurst) return;
    if (!step_once()) return;
    pacing.advance(simulator->scene()->timestep, seconds_since_epoch());
  }
}

/// Makes one step and records it. Stops playing at the end of the scenario, at a breakpoint, or when the simulation
/// fails. Returns whether another step can be made.
bool SimThread::Impl::step_once() {
  if (simulator != nullptr && error.empty()) resume_from_displayed_step();
  if (simulator == nullptr || simulator->finished() || !error.empty()) {
    set_playing(false);
    return false;
  }
  stop.reset();
  try {
    const SensorTimes before = simulator->sensor_times();
    const Clock::time_point begin = Clock::now();
    simulator->step();
    const Clock::time_point stepped = Clock::now();
    simulator->save_state(state);
    simulator->view(view);
    stop = history.record(view, state);
    const Clock::time_point recorded = Clock::now();
    record_time.add(recorded - stepped);
    step_time.add(recorded - begin);
    costs.add(cost_of(stepped - begin, recorded - stepped, before, simulator->sensor_times()));
    record_step();
  } catch (const std::exception& e) {  // the failed step is discarded; the previous one is displayed
    error = e.what();
    set_playing(false);
    if (!history.empty()) displayed = history.last();
    return false;
  }
  changed = true;
  if (simulator->row_due()) add_trace_row();
  if (simulator->finished() || stop) set_playing(false);
  return !simulator->finished() && !stop;
}

void SimThread::Impl::add_trace_row() {
  TraceRow traced{view.time, view.travel, {}};
  for (const SensorModelPtr& sensor : simulator->scene()->sensors)
    if (sensor && sensor->quality == SampleQuality::preview) traced.quality = SampleQuality::preview;
  for (const SensorView& sensor : view.sensors)
    traced.readings.insert(traced.readings.end(), sensor.readings.begin(), sensor.readings.end());
  std::vector<TraceRow>& rows = trace.rows;
  rows.push_back(std::move(traced));
  if (simulator->scene()->duration > 0 || rows.size() < 2 * kEndlessRows) return;
  rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kEndlessRows));
  ++trace.edition;
}

/// Copies the rows for plots and timeline if they changed, at most every kTraceInterval.
void SimThread::Impl::copy_rows(double now, bool even_if_recent) {
  const bool rows_cut = published_trace->edition != trace.edition, steps_cut = lanes->edition != history.edition();
  const bool other_rows = rows_cut || published_trace->rows.size() != trace.rows.size();
  const bool other_steps =
      steps_cut || lanes->rows() != history.size() || (!history.empty() && lanes->steps.back().step != history.last());
  if (!rows_cut && !steps_cut && !even_if_recent && now - last_trace < kTraceInterval) return;
  if (other_rows) published_trace = memory.copy_of(trace);
  if (other_steps || even_if_recent) lanes = memory.lanes_of(history);
  if (other_rows || other_steps) last_trace = now;
}

/// The step before the displayed one, or null if the history does not hold it.
StepPtr SimThread::Impl::previous_step() const {
  if (history.empty()) return nullptr;
  const std::uint64_t shown = displayed.value_or(history.last());
  return shown > 0 && history.contains(shown - 1) ? history.step(shown - 1) : nullptr;
}

/// Returns whether frames are consumed while the simulation plays: a window that is not drawn must cost nothing. A
/// frame that followed a command does not count, because it is always consumed.
bool SimThread::Impl::frames_are_consumed(double now) {
  if (mailbox.full()) return now - last_consumed < kUnconsumed;
  if (!answered) last_consumed = now;
  return true;
}

/// Publishes a frame if the state has changed, at most every kFrameInterval and while frames are consumed, or always if
/// `even_if_recent`.
void SimThread::Impl::publish(bool even_if_recent) {
  const double now = seconds_since_epoch();
  if (!changed) return;
  if (!even_if_recent && (now - last_frame < kFrameInterval || !frames_are_consumed(now))) return;
  copy_rows(now, even_if_recent);
  const std::shared_ptr<SimFrame> frame = simulator == nullptr ? std::make_shared<SimFrame>()
                                          : displayed          ? memory.recorded_frame(history, *displayed)
                                                               : memory.frame_of(*simulator);
  if (simulator == nullptr) {
    frame->scene = frame->simulated = std::make_shared<const SimScene>();
  } else {
    if (displayed) frame->controls = simulator->controls_of(history.state(*displayed));
    frame->simulated = simulator->scene();
    frame->warnings = simulator->warnings();
    if (!journal_failure.empty()) frame->warnings.push_back(journal_failure);
  }
  frame->recorded = displayed.has_value();
  frame->history = {history.empty() ? 0 : history.first(),
                    history.empty() ? 0 : history.last(),
                    history.size(),
                    history.bytes(),
                    record_time.mean_seconds(),
                    history.limits(),
                    lanes};
  if (follows_before && !stepping()) frame->before = previous_step();
  frame->recalled = recalled;
  frame->breakpoints = history.breakpoints();
  frame->stop = stop;
  frame->playing = playing;
  frame->speed = speed;
  frame->measured_speed = playing ? pacing.measured_speed(now) : 0.0;
  frame->step_seconds = step_time.mean_seconds();
  frame->costs = costs.latest();
  frame->trace = published_trace;
  frame->runs = runs;
  frame->commands = commands;
  frame->saved = saved;
  if (recording) frame->recording = recording->state();
  frame->written = written;
  frame->loads = loads;
  frame->replacements = replacements;
  frame->failed = !error.empty();
  frame->error = error.empty() ? refused : error;
  mailbox.post(frame);
  last_frame = now;
  answered = even_if_recent;
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

void SimThread::set_journal_folder(const std::string& folder) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->journal_folder = folder;
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
