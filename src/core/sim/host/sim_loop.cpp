#include "core/sim/host/sim_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/controls.h"
#include "core/run/step.h"
#include "core/sim/host/scene_run.h"
#include "core/sim/scene/scene_patch.h"

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

void PlayState::set_speed(double factor) {
  if (factor > 0 && std::isfinite(factor)) speed_ = factor;
  changed_ = true;
}

void EventQueue::report(SimReport what) {
  const Warned* warned = std::get_if<Warned>(&what);
  if (warned != nullptr && !warned_.insert(warned->text).second) return;
  events_.push_back({command_, std::move(what)});
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

/// Reports that the simulation failed, and pauses it.
void fail_run(SimLoop& loop, const std::string& why) {
  loop.run.error = why;
  loop.play.set_playing(false);
  loop.events.report(Failed{why});
}

/// Begins a run: the history starts with the state before the first step.
void begin_run(SimLoop& loop) {
  loop.recordings.end("the run was restarted", loop.simulator.get());
  SimulatedRun& run = loop.run;
  ++run.number;
  run.error.clear();
  run.trace = {{}, run.trace.edition + 1};
  run.displayed.reset();
  run.stop.reset();
  run.history.clear();
  loop.events.report(RunStarted{run.number});
  if (loop.simulator == nullptr) return;
  loop.simulator->save_state(loop.state);
  run.history.record(loop.simulator->view(), loop.state);
}

void restart_run(SimLoop& loop) {
  if (loop.simulator != nullptr) loop.simulator->reset();
  begin_run(loop);
}

/// Restores the state of the displayed step and discards all later steps.
void resume_from_displayed_step(SimulatedRun& run, Simulator& simulator, SimRecordings& recordings) {
  if (!run.displayed) return;
  const SimState& from = run.history.state(*run.displayed);
  simulator.restore_state(from);
  std::vector<TraceRow>& rows = run.trace.rows;
  while (!rows.empty() && rows.back().time > from.time) rows.pop_back();
  ++run.trace.edition;
  run.history.cut_after(*run.displayed);
  recordings.go_back_to(*run.displayed);
  run.displayed.reset();
}

/// Makes one step of the simulator, with its times and its recordings.
void simulate_step(SimLoop& loop, Simulator& simulator) {
  const SensorTimes before = simulator.sensor_times();
  const Clock::time_point begin = Clock::now();
  simulator.step();
  const Clock::time_point stepped = Clock::now();
  simulator.save_state(loop.state);
  simulator.view(loop.view);
  loop.run.stop = loop.run.history.record(loop.view, loop.state);
  const Clock::time_point recorded = Clock::now();
  loop.times.record.add(recorded - stepped);
  loop.times.step.add(recorded - begin);
  loop.times.costs.add(cost_of(stepped - begin, recorded - stepped, before, simulator.sensor_times()));
  loop.recordings.follow(loop.view, simulator);
}

void add_trace_row(Trace& trace, const StepView& view, const SimScene& scene) {
  auto quality = SampleQuality::polished;
  for (const SensorModelPtr& sensor : scene.sensors)
    if (sensor && sensor->quality == SampleQuality::preview) quality = SampleQuality::preview;
  std::vector<TraceRow>& rows = trace.rows;
  rows.push_back(trace_row_of(view, quality));
  if (scene.duration > 0 || rows.size() < 2 * kEndlessRows) return;
  rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kEndlessRows));
  ++trace.edition;
}

void carry_out(SimLoop& loop, const PlayCommand& /*command*/) {
  const bool is_past = loop.run.displayed && *loop.run.displayed < loop.run.history.last();
  if (is_past) loop.run.error.clear();  // the failure happened later
  const bool is_over = loop.simulator != nullptr && loop.simulator->finished() && !is_past;
  if (is_over || !loop.run.error.empty()) restart_run(loop);
  loop.play.set_playing(loop.simulator != nullptr);
}

void carry_out(SimLoop& loop, const PauseCommand& /*command*/) {
  loop.play.set_playing(false);
}

void carry_out(SimLoop& loop, const StepCommand& command) {
  for (int i = 0; i < command.steps && make_step(loop); ++i) {
  }
}

void carry_out(SimLoop& loop, const ResetCommand& /*command*/) {
  restart_run(loop);
  loop.play.set_playing(false);
}

void carry_out(SimLoop& loop, const SpeedCommand& command) {
  loop.play.set_speed(command.factor);
}

/// Replaces the scene by the one that `make` returns. The previous one stays if `make` throws.
template <class Make>
void load_scene_by(SimLoop& loop, const Make& make) {
  try {
    std::unique_ptr<Simulator> made = make();
    loop.recordings.end("another scene was opened", loop.simulator.get());  // while its scene files can be written
    loop.simulator = std::move(made);
  } catch (const std::exception& e) {
    return loop.events.report(Refused{e.what()});
  }
  loop.events.begin_scene();
  begin_run(loop);
  loop.times = {};
  loop.play.set_playing(false);  // a loaded scene is paused
  loop.events.report(SceneLoaded{});
}

void carry_out(SimLoop& loop, const LoadScenarioCommand& command) {
  load_scene_by(loop, [&] { return Simulator::make_scenario(command.model, command.scenario); });
}

/// Gives the actuators of `made` the controls that `before` has for actuators of the same names.
void keep_controls(const Simulator& before, Simulator& made) {
  SimState state;
  before.save_state(state);
  const std::vector<double> controls = before.controls_of(state).controls;
  const std::vector<SceneActuator>&from = before.scene()->controls.actuators, &to = made.scene()->controls.actuators;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto found = std::ranges::find(from, to[i].name, &SceneActuator::name);
    const auto index = static_cast<std::size_t>(found - from.begin());
    if (index < controls.size()) made.edit(SetControl{static_cast<int>(i), controls[index]});
  }
}

void carry_out(SimLoop& loop, const LoadSceneCommand& command) {
  SceneLeadPtr lead;
  load_scene_by(loop, [&] {
    std::unique_ptr<Simulator> made = Simulator::load(command.file, command.attachments);
    lead = lead_simulator(*made, command.lead, command.file);
    if (command.keeps_controls && loop.simulator != nullptr) keep_controls(*loop.simulator, *made);
    return made;
  });
  if (lead == nullptr) return;
  for (const std::string& note : lead->notes) loop.events.report(Warned{note});
}

void carry_out(SimLoop& loop, const ReplaceModelCommand& command) {
  if (loop.simulator == nullptr || !uses(*loop.simulator->scene(), command.replaced)) return;
  loop.recordings.end("another layout reads from there on", loop.simulator.get());
  try {
    loop.simulator->replace_model(command.replaced, command.model);
    if (loop.run.error.empty()) loop.run.history.replace_newest(loop.simulator->view());
    loop.events.report(ModelReplaced{});
  } catch (const std::exception& e) {
    loop.events.report(Refused{e.what()});  // the previous model stays
  }
}

void carry_out(SimLoop& loop, const SaveSceneCommand& command) {
  SceneSaved saved{command.file, ""};
  try {
    if (loop.simulator == nullptr) throw Error(command.file, "there is no scene to write");
    saved.note = save_scene(*loop.simulator, command.file);
  } catch (const std::exception& e) {
    saved.error = e.what();
  }
  loop.events.report(std::move(saved));
}

void carry_out(SimLoop& loop, const NameLayoutCommand& command) {
  SceneSaved saved{command.scene, ""};
  try {
    for (const auto& [file, text] : with_layout_file(command.scene, command.geoms, command.layout))
      write_file_atomically(file, text);
  } catch (const std::exception& e) {
    saved.error = e.what();
  }
  loop.events.report(std::move(saved));
}

void carry_out(SimLoop& loop, const ScrubCommand& command) {
  if (loop.run.history.empty()) return;
  loop.play.set_playing(false);
  loop.run.displayed = std::clamp(command.step, loop.run.history.first(), loop.run.history.last());
  if (*loop.run.displayed == loop.run.history.last() && loop.run.error.empty())
    loop.run.displayed.reset();  // the simulator has the newest step
}

void carry_out(SimLoop& loop, const FollowStepBeforeCommand& command) {
  loop.follows_before = command.on;
}

void carry_out(SimLoop& loop, const RecallCommand& command) {
  StepsRecalled recalled;
  recalled.asker = command.asker;
  for (const std::uint64_t step : command.steps)
    if (loop.run.history.contains(step)) recalled.steps.push_back(loop.run.history.step(step));
  loop.events.report(std::move(recalled));
}

void carry_out(SimLoop& loop, const BreakpointsCommand& command) {
  loop.run.history.set_breakpoints(command.breakpoints);
}

void carry_out(SimLoop& loop, const StepHistoryLimitsCommand& command) {
  loop.run.history.set_limits(command.limits);
  if (loop.run.displayed && !loop.run.history.contains(*loop.run.displayed))
    loop.run.displayed = loop.run.history.first();
}

void carry_out(SimLoop& loop, const EditSceneCommand& command) {
  if (loop.simulator != nullptr && !loop.run.displayed && loop.run.error.empty()) loop.simulator->edit(command.edit);
}

void carry_out(SimLoop& loop, const LoadKeyframeCommand& command) {
  if (loop.simulator != nullptr && loop.simulator->load_keyframe(command.keyframe)) begin_run(loop);
  loop.play.set_playing(false);
}

void carry_out(SimLoop& loop, const RecordCommand& command) {
  loop.recordings.begin(command, loop.simulator.get());
}

void carry_out(SimLoop& loop, const EndRecordingCommand& /*command*/) {
  loop.recordings.end("", loop.simulator.get());
}

void carry_out(SimLoop& loop, const WriteRecordingCommand& command) {
  loop.recordings.write_again(command.file, loop.simulator.get());
}

void carry_out(SimLoop& loop, const ExportHistoryCommand& command) {
  loop.recordings.export_history(command, loop.run.history, loop.simulator.get());
}

void carry_out(SimLoop& /*loop*/, const QuitCommand& /*command*/) {}

/// Copies the rows for plots and timeline if they changed, at most every kTraceInterval.
void copy_rows(CopiedRows& copied, const SimulatedRun& run, FrameMemory& memory, double now, bool all_rows) {
  const Trace& copy = *copied.trace;
  const HistoryLanes& lanes = *copied.lanes;
  const bool rows_cut = copy.edition != run.trace.edition, steps_cut = lanes.edition != run.history.edition();
  const bool other_rows = rows_cut || copy.rows.size() != run.trace.rows.size();
  const bool other_steps = steps_cut || lanes.rows() != run.history.size() ||
                           (!run.history.empty() && lanes.steps.back().step != run.history.last());
  if (!rows_cut && !steps_cut && !all_rows && now - copied.copied_at < kTraceInterval) return;
  if (other_rows) copied.trace = memory.copy_of(run.trace);
  if (other_steps || all_rows) copied.lanes = memory.lanes_of(run.history);
  if (other_rows || other_steps) copied.copied_at = now;
}

/// Returns the step before the displayed step, or null if the history does not have it.
StepPtr previous_step(const SimulatedRun& run) {
  if (run.history.empty()) return nullptr;
  const std::uint64_t shown = run.displayed.value_or(run.history.last());
  return shown > 0 && run.history.contains(shown - 1) ? run.history.step(shown - 1) : nullptr;
}

}  // namespace

void carry_out(SimLoop& loop, CommandId id, const SimCommand& command) {
  loop.events.set_command(id);
  const std::size_t events_before = loop.events.all().size();
  try {
    std::visit([&loop](const auto& c) { carry_out(loop, c); }, command);
  } catch (const std::exception& e) {
    fail_run(loop, e.what());
  }
  if (loop.events.all().size() == events_before) loop.events.report(Done{});
  loop.events.set_command(0);
}

bool make_step(SimLoop& loop) {
  SimulatedRun& run = loop.run;
  Simulator* const simulator = loop.simulator.get();
  if (simulator != nullptr && run.error.empty()) resume_from_displayed_step(run, *simulator, loop.recordings);
  if (simulator == nullptr || simulator->finished() || !run.error.empty()) {
    if (loop.play.playing()) loop.events.report(Finished{});
    loop.play.set_playing(false);
    return false;
  }
  run.stop.reset();
  try {
    simulate_step(loop, *simulator);
  } catch (const std::exception& e) {  // the failed step is discarded; the previous one is displayed
    fail_run(loop, e.what());
    if (!run.history.empty()) run.displayed = run.history.last();
    return false;
  }
  if (simulator->row_due()) add_trace_row(run.trace, loop.view, *simulator->scene());
  if (run.stop) loop.events.report(Stopped{*run.stop, simulator->scene()});
  if (simulator->finished()) loop.events.report(Finished{});
  if (simulator->finished() || run.stop) loop.play.set_playing(false);
  return !simulator->finished() && !run.stop;
}

std::shared_ptr<SimFrame> make_frame(SimLoop& loop, double now, bool all_rows, bool previous) {
  const SimulatedRun& run = loop.run;
  Simulator* const simulator = loop.simulator.get();
  copy_rows(loop.rows, run, loop.memory, now, all_rows);
  const std::shared_ptr<SimFrame> frame = simulator == nullptr ? std::make_shared<SimFrame>()
                                          : run.displayed      ? loop.memory.recorded_frame(run.history, *run.displayed)
                                                               : loop.memory.frame_of(*simulator);
  if (simulator == nullptr) {
    frame->scene = frame->simulated = std::make_shared<const SimScene>();
  } else {
    if (run.displayed) frame->controls = simulator->controls_of(run.history.state(*run.displayed));
    frame->simulated = simulator->scene();
    for (const std::string& repair : simulator->repairs()) loop.events.report(Warned{repair});
    for (const std::string& warning : simulator->warnings()) loop.events.report(Warned{warning});
  }
  frame->recording = loop.recordings.state();
  frame->recorded = run.displayed.has_value();
  frame->history = {run.history.empty() ? 0 : run.history.first(),
                    run.history.empty() ? 0 : run.history.last(),
                    run.history.size(),
                    run.history.bytes(),
                    loop.times.record.mean_seconds(),
                    run.history.limits(),
                    loop.rows.lanes};
  if (loop.follows_before && previous) frame->before = previous_step(run);
  frame->breakpoints = run.history.breakpoints();
  frame->stop = run.stop;
  frame->playing = loop.play.playing();
  frame->speed = loop.play.speed();
  frame->step_seconds = loop.times.step.mean_seconds();
  frame->costs = loop.times.costs.latest();
  frame->trace = loop.rows.trace;
  frame->runs = run.number;
  frame->failed = !run.error.empty();
  frame->error = run.error;
  return frame;
}

}  // namespace taxel
