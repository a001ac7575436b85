// The commands of the simulation's thread.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/sim/host/sim_thread_impl.h"

namespace taxel {
namespace {

bool uses(const SimScene& scene, const SensorModelPtr& model) {
  return std::find(scene.sensors.begin(), scene.sensors.end(), model) != scene.sensors.end();
}

}  // namespace

/// Begins a run: the history starts with the state before the first step.
void SimThread::Impl::begin_run() {
  end_recording("the run began anew");
  ++runs;
  error.clear();
  trace = {{}, trace.edition + 1};
  displayed.reset();
  stop.reset();
  history.clear();
  if (simulator == nullptr) return;
  simulator->save_state(state);
  history.record(simulator->view(), state);
}

/// Restores the state of the displayed step and discards all later steps.
void SimThread::Impl::resume_from_displayed_step() {
  if (!displayed) return;
  const SimState& from = history.state(*displayed);
  simulator->restore_state(from);
  while (!trace.rows.empty() && trace.rows.back().time > from.time) trace.rows.pop_back();
  ++trace.edition;
  history.cut_after(*displayed);
  if (recording) recording->go_back_to(*displayed);
  displayed.reset();
}

void SimThread::Impl::scrub(std::uint64_t step) {
  if (history.empty()) return;
  set_playing(false);
  displayed = std::clamp(step, history.first(), history.last());
  if (*displayed == history.last() && error.empty()) displayed.reset();  // the simulator has the newest step
}

void SimThread::Impl::recall(const RecallCommand& asked) {
  auto found = std::make_shared<RecalledSteps>();
  found->number = asked.number;
  for (const std::uint64_t step : asked.steps)
    if (history.contains(step)) found->steps.push_back(history.step(step));
  recalled = std::move(found);
}

void SimThread::Impl::execute_on_history(const SimCommand& command) {
  if (const auto* to = std::get_if<ScrubCommand>(&command)) {
    scrub(to->step);
  } else if (const auto* follow = std::get_if<FollowStepBeforeCommand>(&command)) {
    follows_before = follow->on;
  } else if (const auto* asked = std::get_if<RecallCommand>(&command)) {
    recall(*asked);
  } else if (const auto* breakpoints = std::get_if<BreakpointsCommand>(&command)) {
    history.set_breakpoints(breakpoints->breakpoints);
  } else if (const auto* limits = std::get_if<StepHistoryLimitsCommand>(&command)) {
    history.set_limits(limits->limits);
    if (displayed && !history.contains(*displayed)) displayed = history.first();
  }
}

/// Executes a command that changes or saves the scene. Returns false for other commands.
bool SimThread::Impl::execute_on_scene(const SimCommand& command) {
  if (const auto* edit = std::get_if<EditSceneCommand>(&command)) {
    if (simulator != nullptr && !displayed && error.empty()) simulator->edit(edit->edit);
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
    std::unique_ptr<Simulator> made = make();
    end_recording("another scene was opened");  // while its scene files can be written
    simulator = std::move(made);
  } catch (const std::exception& e) {
    refused = e.what();
    return;
  }
  refused.clear();
  begin_run();
  step_time = record_time = {};
  costs = {};
  set_playing(false);  // a loaded scene is paused
}

void SimThread::Impl::replace_model(const ReplaceModelCommand& command) {
  ++replacements;
  refused.clear();
  try {
    if (simulator == nullptr) return;
    if (recording && uses(*simulator->scene(), command.replaced)) end_recording("another layout reads from there on");
    simulator->replace_model(command.replaced, command.model);
    if (error.empty()) history.replace_newest(simulator->view());
  } catch (const std::exception& e) {
    refused = e.what();  // the previous model stays
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
    const bool of_the_past = displayed && *displayed < history.last();
    if (of_the_past) error.clear();  // the failure happened later
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
  } else if (const auto* run = std::get_if<LoadScenarioCommand>(&command)) {
    load([&] { return Simulator::make_scenario(run->model, run->scenario); });
  } else if (const auto* replace = std::get_if<ReplaceModelCommand>(&command)) {
    replace_model(*replace);
  } else if (const auto* scene = std::get_if<LoadSceneCommand>(&command)) {
    load([&] { return Simulator::load(scene->file, scene->attachments); });
  } else if (!execute_on_scene(command) && !execute_on_recording(command)) {
    execute_on_history(command);
  }
}

}  // namespace taxel
