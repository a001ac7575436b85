#include "core/sim/host/sim_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/run/step.h"
#include "core/sim/host/scene_run.h"

namespace taxel {
namespace {

/// Returns a shared value. The thread that releases the value last calls give_back(value).
template <class T, class GiveBack>
std::shared_ptr<T> shared(T value, GiveBack give_back) {
  return {std::make_unique<T>(std::move(value)).release(), [give_back = std::move(give_back)](T* done) {
            const std::unique_ptr<T> owner(done);
            give_back(*owner);
          }};
}

}  // namespace

/// Makes a new frame from reused memory, and fills it.
template <class Fill>
std::shared_ptr<SimFrame> FrameMemory::make_frame(const Fill& fill) {
  Frame memory = frames_->pop();
  SimFrame frame;
  frame.geom_poses = std::move(memory.geom_poses);
  frame.sensors = std::move(memory.sensors);
  fill(frame, memory.hits);
  return shared(std::move(frame), [pool = frames_, hits = std::move(memory.hits)](SimFrame& done) {
    for (SensorStep& sensor : done.sensors) sensor.model.reset();  // only memory is retained
    pool->put({std::move(done.geom_poses), std::move(done.sensors), hits});
  });
}

std::shared_ptr<SimFrame> FrameMemory::recorded_frame(const StepHistory& history, std::uint64_t step) {
  return make_frame([&](SimFrame& frame, FilledHits& hits) {
    hits.clear();
    history.fill_step(step, frame);
  });
}

std::shared_ptr<SimFrame> FrameMemory::frame_of(const Simulator& simulator) {
  return make_frame([&](SimFrame& frame, FilledHits& hits) { simulator.fill_frame(frame, hits); });
}

std::shared_ptr<const Trace> FrameMemory::copy_of(const Trace& trace) {
  Trace copy = traces_->pop();
  const std::size_t copied_rows = copy.rows.size();
  if (copy.edition == trace.edition && copied_rows <= trace.rows.size()) {
    copy.rows.insert(copy.rows.end(), trace.rows.begin() + static_cast<std::ptrdiff_t>(copied_rows), trace.rows.end());
  } else {
    copy = trace;
  }
  return shared(std::move(copy), [pool = traces_](Trace& done) { pool->put(std::move(done)); });
}

std::shared_ptr<const HistoryLanes> FrameMemory::lanes_of(const StepHistory& history) {
  HistoryLanes lanes = lanes_->pop();
  history.copy_lanes(lanes);
  return shared(std::move(lanes), [pool = lanes_](HistoryLanes& done) { pool->put(std::move(done)); });
}

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kTraceInterval = 1.0 / 30.0;  // [s] shortest time between copies of the trace
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

bool uses(const SimScene& scene, const SensorModelPtr& model) {
  return std::find(scene.sensors.begin(), scene.sensors.end(), model) != scene.sensors.end();
}

}  // namespace

SimLoop::SimLoop() : recordings_([this](SimReport what) { report(std::move(what)); }) {}

void SimLoop::carry_out(CommandId id, const SimCommand& command) {
  current_command_ = id;
  const std::size_t events_before = events_.size();
  try {
    std::visit([this](const auto& c) { run(c); }, command);
  } catch (const std::exception& e) {
    fail(e.what());
  }
  if (events_.size() == events_before) report(Done{});
  current_command_ = 0;
}

/// Adds an event. A warning is reported once per scene.
void SimLoop::report(SimReport what) {
  const Warned* warned = std::get_if<Warned>(&what);
  if (warned != nullptr && !warned_.insert(warned->text).second) return;
  events_.push_back({current_command_, std::move(what)});
}

void SimLoop::fail(const std::string& why) {
  error_ = why;
  set_playing(false);
  report(Failed{why});
}

void SimLoop::set_playing(bool on) {
  playing_ = on;
  pace_changed_ = true;
}

/// Begins a run: the history starts with the state before the first step.
void SimLoop::begin_run() {
  recordings_.end("the run was restarted", simulator_.get());
  ++runs_;
  error_.clear();
  rows_.trace = {{}, rows_.trace.edition + 1};
  displayed_.reset();
  stop_.reset();
  history_.clear();
  report(RunStarted{runs_});
  if (simulator_ == nullptr) return;
  simulator_->save_state(state_);
  history_.record(simulator_->view(), state_);
}

void SimLoop::rewind() {
  if (simulator_ != nullptr) simulator_->reset();
  begin_run();
}

/// Restores the state of the displayed step and discards all later steps.
void SimLoop::resume_from_displayed_step() {
  if (!displayed_) return;
  const SimState& from = history_.state(*displayed_);
  simulator_->restore_state(from);
  std::vector<TraceRow>& rows = rows_.trace.rows;
  while (!rows.empty() && rows.back().time > from.time) rows.pop_back();
  ++rows_.trace.edition;
  history_.cut_after(*displayed_);
  recordings_.go_back_to(*displayed_);
  displayed_.reset();
}

bool SimLoop::step() {
  if (simulator_ != nullptr && error_.empty()) resume_from_displayed_step();
  if (simulator_ == nullptr || simulator_->finished() || !error_.empty()) {
    if (playing_) report(Finished{});
    set_playing(false);
    return false;
  }
  stop_.reset();
  try {
    make_step();
  } catch (const std::exception& e) {  // the failed step is discarded; the previous one is displayed
    fail(e.what());
    if (!history_.empty()) displayed_ = history_.last();
    return false;
  }
  if (simulator_->row_due()) add_trace_row();
  if (stop_) report(Stopped{*stop_, simulator_->scene()});
  if (simulator_->finished()) report(Finished{});
  if (simulator_->finished() || stop_) set_playing(false);
  return !simulator_->finished() && !stop_;
}

void SimLoop::make_step() {
  const SensorTimes before = simulator_->sensor_times();
  const Clock::time_point begin = Clock::now();
  simulator_->step();
  const Clock::time_point stepped = Clock::now();
  simulator_->save_state(state_);
  simulator_->view(view_);
  stop_ = history_.record(view_, state_);
  const Clock::time_point recorded = Clock::now();
  times_.record.add(recorded - stepped);
  times_.step.add(recorded - begin);
  times_.costs.add(cost_of(stepped - begin, recorded - stepped, before, simulator_->sensor_times()));
  recordings_.follow(view_, *simulator_);
}

void SimLoop::add_trace_row() {
  auto quality = SampleQuality::polished;
  for (const SensorModelPtr& sensor : simulator_->scene()->sensors)
    if (sensor && sensor->quality == SampleQuality::preview) quality = SampleQuality::preview;
  std::vector<TraceRow>& rows = rows_.trace.rows;
  rows.push_back(trace_row_of(view_, quality));
  if (simulator_->scene()->duration > 0 || rows.size() < 2 * kEndlessRows) return;
  rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kEndlessRows));
  ++rows_.trace.edition;
}

void SimLoop::run(const PlayCommand& /*command*/) {
  const bool is_past = displayed_ && *displayed_ < history_.last();
  if (is_past) error_.clear();  // the failure happened later
  const bool is_over = simulator_ != nullptr && simulator_->finished() && !is_past;
  if (is_over || !error_.empty()) rewind();
  set_playing(simulator_ != nullptr);
}

void SimLoop::run(const PauseCommand& /*command*/) {
  set_playing(false);
}

void SimLoop::run(const StepCommand& command) {
  for (int i = 0; i < command.steps && step(); ++i) {
  }
}

void SimLoop::run(const ResetCommand& /*command*/) {
  rewind();
  set_playing(false);
}

void SimLoop::run(const SpeedCommand& command) {
  if (command.factor > 0 && std::isfinite(command.factor)) speed_ = command.factor;
  pace_changed_ = true;
}

void SimLoop::load(const std::function<std::unique_ptr<Simulator>()>& make) {
  try {
    std::unique_ptr<Simulator> made = make();
    recordings_.end("another scene was opened", simulator_.get());  // while its scene files can be written
    simulator_ = std::move(made);
  } catch (const std::exception& e) {
    return report(Refused{e.what()});
  }
  warned_.clear();
  begin_run();
  times_ = {};
  set_playing(false);  // a loaded scene is paused
  report(SceneLoaded{});
}

void SimLoop::run(const LoadScenarioCommand& command) {
  load([&] { return Simulator::make_scenario(command.model, command.scenario); });
}

void SimLoop::run(const LoadSceneCommand& command) {
  SceneLeadPtr lead;
  load([&] {
    std::unique_ptr<Simulator> made = Simulator::load(command.file, command.attachments);
    lead = lead_simulator(*made, command.lead, command.file);
    return made;
  });
  if (lead == nullptr) return;
  for (const std::string& note : lead->notes) report(Warned{note});
}

void SimLoop::run(const ReplaceModelCommand& command) {
  if (simulator_ == nullptr || !uses(*simulator_->scene(), command.replaced)) return;
  recordings_.end("another layout reads from there on", simulator_.get());
  try {
    simulator_->replace_model(command.replaced, command.model);
    if (error_.empty()) history_.replace_newest(simulator_->view());
    report(ModelReplaced{});
  } catch (const std::exception& e) {
    report(Refused{e.what()});  // the previous model stays
  }
}

void SimLoop::run(const SaveSceneCommand& command) {
  SceneSaved saved{command.file, ""};
  try {
    if (simulator_ == nullptr) throw Error(command.file, "there is no scene to write");
    simulator_->save_scene(command.file);
  } catch (const std::exception& e) {
    saved.error = e.what();
  }
  report(std::move(saved));
}

void SimLoop::run(const ScrubCommand& command) {
  if (history_.empty()) return;
  set_playing(false);
  displayed_ = std::clamp(command.step, history_.first(), history_.last());
  if (*displayed_ == history_.last() && error_.empty()) displayed_.reset();  // the simulator has the newest step
}

void SimLoop::run(const FollowStepBeforeCommand& command) {
  follows_before_ = command.on;
}

void SimLoop::run(const RecallCommand& command) {
  StepsRecalled recalled;
  recalled.asker = command.asker;
  for (const std::uint64_t step : command.steps)
    if (history_.contains(step)) recalled.steps.push_back(history_.step(step));
  report(std::move(recalled));
}

void SimLoop::run(const BreakpointsCommand& command) {
  history_.set_breakpoints(command.breakpoints);
}

void SimLoop::run(const StepHistoryLimitsCommand& command) {
  history_.set_limits(command.limits);
  if (displayed_ && !history_.contains(*displayed_)) displayed_ = history_.first();
}

void SimLoop::run(const EditSceneCommand& command) {
  if (simulator_ != nullptr && !displayed_ && error_.empty()) simulator_->edit(command.edit);
}

void SimLoop::run(const LoadKeyframeCommand& command) {
  if (simulator_ != nullptr && simulator_->load_keyframe(command.keyframe)) begin_run();
  set_playing(false);
}

void SimLoop::run(const RecordCommand& command) {
  recordings_.begin(command, simulator_.get());
}

void SimLoop::run(const EndRecordingCommand& /*command*/) {
  recordings_.end("", simulator_.get());
}

void SimLoop::run(const WriteRecordingCommand& command) {
  recordings_.write_again(command.file, simulator_.get());
}

void SimLoop::run(const ExportHistoryCommand& command) {
  recordings_.export_history(command, history_, simulator_.get());
}

void SimLoop::run(const QuitCommand& /*command*/) {}

/// Copies the rows for plots and timeline if they changed, at most every kTraceInterval.
void SimLoop::copy_rows(double now, bool all_rows) {
  const Trace& copy = *rows_.copied_trace;
  const HistoryLanes& lanes = *rows_.lanes;
  const bool rows_cut = copy.edition != rows_.trace.edition, steps_cut = lanes.edition != history_.edition();
  const bool other_rows = rows_cut || copy.rows.size() != rows_.trace.rows.size();
  const bool other_steps =
      steps_cut || lanes.rows() != history_.size() || (!history_.empty() && lanes.steps.back().step != history_.last());
  if (!rows_cut && !steps_cut && !all_rows && now - rows_.copied_at < kTraceInterval) return;
  if (other_rows) rows_.copied_trace = memory_.copy_of(rows_.trace);
  if (other_steps || all_rows) rows_.lanes = memory_.lanes_of(history_);
  if (other_rows || other_steps) rows_.copied_at = now;
}

/// Returns the step before the displayed step, or null if the history does not have it.
StepPtr SimLoop::previous_step() const {
  if (history_.empty()) return nullptr;
  const std::uint64_t shown = displayed_.value_or(history_.last());
  return shown > 0 && history_.contains(shown - 1) ? history_.step(shown - 1) : nullptr;
}

std::shared_ptr<SimFrame> SimLoop::make_frame(double now, bool all_rows, bool previous) {
  copy_rows(now, all_rows);
  const std::shared_ptr<SimFrame> frame = simulator_ == nullptr ? std::make_shared<SimFrame>()
                                          : displayed_          ? memory_.recorded_frame(history_, *displayed_)
                                                                : memory_.frame_of(*simulator_);
  if (simulator_ == nullptr) {
    frame->scene = frame->simulated = std::make_shared<const SimScene>();
  } else {
    if (displayed_) frame->controls = simulator_->controls_of(history_.state(*displayed_));
    frame->simulated = simulator_->scene();
    for (const std::string& repair : simulator_->repairs()) report(Warned{repair});
    for (const std::string& warning : simulator_->warnings()) report(Warned{warning});
  }
  frame->recording = recordings_.state();
  frame->recorded = displayed_.has_value();
  frame->history = {history_.empty() ? 0 : history_.first(),
                    history_.empty() ? 0 : history_.last(),
                    history_.size(),
                    history_.bytes(),
                    times_.record.mean_seconds(),
                    history_.limits(),
                    rows_.lanes};
  if (follows_before_ && previous) frame->before = previous_step();
  frame->breakpoints = history_.breakpoints();
  frame->stop = stop_;
  frame->playing = playing_;
  frame->speed = speed_;
  frame->step_seconds = times_.step.mean_seconds();
  frame->costs = times_.costs.latest();
  frame->trace = rows_.copied_trace;
  frame->runs = runs_;
  frame->failed = !error_.empty();
  frame->error = error_;
  return frame;
}

}  // namespace taxel
