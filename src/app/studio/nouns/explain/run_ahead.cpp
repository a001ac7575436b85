// Runs that are made at once to display one of their steps: the run of the paper's artifact, whose largest step is
// explained, and the run after a remedy, which displays the step of the jump again.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/base/text/message.h"
#include "core/base/text/rounded.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

/// Number of steps per frame. More would stop the window for a while where steps are slow.
constexpr int kStepsPerFrame = 200;

/// Returns the model that the simulation reads by, if it simulates one sensor of the document. Null otherwise.
SensorModelPtr simulated_model(const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  if (!shown.run.simulates_document || shown.document.is_scene || !frame || !frame->simulated ||
      frame->simulated->sensors.empty())
    return nullptr;
  return frame->simulated->sensors.front();
}

/// Returns whether the simulation reads by the polished model of all edits, which is not `ahead.without`.
bool reads_wanted_model(const Shown& shown, const RunAhead& ahead) {
  const SensorModelPtr model = simulated_model(shown);
  return model && model != ahead.without && model->quality == SampleQuality::polished &&
         shown.document.editing.compiled && !shown.document.polishing.holds_run;
}

/// Returns whether the user or the simulation has ended the run.
bool is_interrupted(const Shown& shown) {
  const SimFrame& frame = *shown.run.frame;
  return shown.run.playing || frame.recorded || frame.failed || frame.stop || simulated_model(shown) == nullptr;
}

/// Requests the next steps of the run. Returns true if all steps are made and recorded.
bool makes_last_step(WindowUi& ui, const SimFrame& frame, RunAhead& ahead) {
  const std::uint64_t newest = frame.history.last;
  if (!frame.finished && newest < ahead.until) {
    if (newest == ahead.requested_at) return false;  // they are not made yet
    ahead.requested_at = newest;
    const std::uint64_t left = ahead.until - newest;
    ui.post(StepAhead{static_cast<int>(std::min<std::uint64_t>(left, kStepsPerFrame))});
    return false;
  }
  const HistoryLanes* lanes = frame.history.lanes.get();
  return lanes != nullptr && lanes->rows() > 0 && lanes->steps.back().step == newest;
}

}  // namespace

void show_largest_change(WindowUi& ui, RunAhead& ahead) {
  ui.post(BreakpointsCommand{});
  ahead = {.phase = RunAhead::Phase::waits_for_model, .until = std::numeric_limits<std::uint64_t>::max()};
}

bool advance_run_ahead(WindowUi& ui, const Shown& shown, RunAhead& ahead) {
  using Phase = RunAhead::Phase;
  const SimFramePtr& frame = shown.run.frame;
  if (ahead.phase == Phase::none || !frame) return false;
  if (!shown.document.editing.problem.empty()) {
    ahead = {};
  } else if (ahead.phase == Phase::waits_for_model) {
    if (!reads_wanted_model(shown, ahead)) return false;
    ahead.runs = frame->runs;
    ahead.phase = Phase::begins;
    ui.post(ResetSimulation{});
  } else if (ahead.phase == Phase::begins) {
    if (frame->runs == ahead.runs) return false;
    ahead.phase = Phase::runs;
    ahead.requested_at = std::numeric_limits<std::uint64_t>::max();
  }
  if (ahead.phase != Phase::runs) return false;
  if (is_interrupted(shown)) {
    ahead = {};
    return false;
  }
  return makes_last_step(ui, *frame, ahead);
}

namespace {

/// Returns the index of the sensor with a reading, and that of the taxel in its layout.
std::pair<int, int> taxel_of_reading(const SimFrame& frame, std::size_t reading) {
  int sensor = 0;
  while (reading >= frame.sensors[static_cast<std::size_t>(sensor)].readings.size())
    reading -= frame.sensors[static_cast<std::size_t>(sensor++)].readings.size();
  return {sensor, static_cast<int>(reading)};
}

/// Returns the sentence about the largest change of a run.
std::string largest_change_text(const SimFrame& frame, const ReadingChange& change, std::size_t sensor,
                                const Taxel& taxel) {
  const HistoryLanes& lanes = *frame.history.lanes;
  const ReadingUnit unit = shown_unit(frame.sensors[sensor].model->layout.readout.aggregate);
  const NumberPair readings = pair_in_unit(change.before, change.after, unit);
  const double before = lanes.sensor(change.row - 1, sensor).force, after = lanes.sensor(change.row, sensor).force;
  const bool is_constant = std::abs(after - before) <= frame.breakpoints.equal_force * std::max(before, after);
  const double peak = largest_reading(lanes, change.reading), size = std::abs(change.after - change.before);
  const double of_sensor = lanes.sensor(lanes.rows() - 1, sensor).largest_reading;
  const std::string force = fmt::format("the force {} ({} %)", is_constant ? "is constant" : "changes",
                                        rounded_change(before > 0 ? 100 * (after / before - 1) : 0.0, 2, 2));
  return fmt::format(
      "The largest step of the run: taxel {}{} {} from {} to {} at {:.6g} s, {:.3g} % of this taxel's largest reading "
      "({:.3g} % of the sensor's, by which the plot divides), while {}.",
      taxel.id, taxel.name.empty() ? "" : " (" + taxel.name + ")", change.after < change.before ? "falls" : "rises",
      readings.first, readings.second, lanes.steps[change.row].time, peak > 0 ? 100 * size / peak : 0.0,
      of_sensor > 0 ? 100 * size / of_sensor : 0.0, force);
}

void show_change(App& app, const ReadingChange& change, bool with_message) {
  const SimFrame& frame = *app.shown->run.frame;
  const auto [sensor, index] = taxel_of_reading(frame, change.reading);
  const Layout& layout = frame.sensors[static_cast<std::size_t>(sensor)].model->layout;
  const Taxel& taxel = layout.taxels[static_cast<std::size_t>(index)];
  const std::uint64_t step = frame.history.lanes->steps[change.row].step;
  app.ui->post(ScrubTo{step});
  click_taxel_of(app.viewer->selection, {sensor, taxel.id}, false);
  explain_reading(*app.viewer, *app.shown, app.get<ExplainState>(), app.get<PanelsShown>()[kExplain]);
  app.get<PlotState>().close_up = PlotCloseUp{{sensor, taxel.id}, step};
  app.ui->open_in_front(app.get<PanelsShown>()[kPlot]);
  app.ui->open_in_front(app.get<PanelsShown>()[kExplain]);
  if (!with_message) return;
  add_message(app.get<Messages>(), Severity::warning,
              largest_change_text(frame, change, static_cast<std::size_t>(sensor), taxel), ImGui::GetTime(),
              Holds::for_run);
  app.get<ExplainState>().run_of_message = frame.runs;
}

}  // namespace

void show_result(App& app) {
  RunAhead& ahead = app.get<RunAhead>();
  const SimFrame& frame = *app.shown->run.frame;
  const bool is_same = ahead.shows == ShownAfterRun::same_step;
  if (is_same) app.ui->post(ScrubTo{ahead.displayed});
  const std::optional<ReadingChange> change = is_same ? std::nullopt : largest_change(*frame.history.lanes);
  if (change) show_change(app, *change, true);
  ahead = {};
}

void end_message_of_run(App& app) {
  std::uint64_t& run = app.get<ExplainState>().run_of_message;
  if (run == 0 || !app.shown->run.frame || app.shown->run.frame->runs == run) return;
  end_messages(app.get<Messages>(), Holds::for_run);
  run = 0;
}

std::string run_ahead_hint(const Shown& shown, const RunAhead& ahead) {
  using Phase = RunAhead::Phase;
  if (ahead.phase == Phase::none) return {};
  const bool is_same = ahead.shows == ShownAfterRun::same_step;
  const std::string purpose =
      is_same ? "Making the run again with the changed layout" : "Searching for the largest step of the run";
  if (ahead.phase != Phase::runs || !shown.run.frame) return purpose + ": the samples are prepared...";
  const std::uint64_t made = shown.run.frame->history.last;
  return is_same ? fmt::format("{}: {} of {} steps...", purpose, made, ahead.until)
                 : fmt::format("{}: {} steps are made...", purpose, made);
}

void answer_why_it_jumped(App& app) {
  if (!app.shown->run.has_history() || app.shown->run.frame->history.lanes == nullptr) return;
  if (const auto change = largest_change(*app.shown->run.frame->history.lanes)) show_change(app, *change, false);
}

void answer_at_first_sight(App& app) {
  bool& was_in_front = app.get<ExplainState>().was_in_front;
  const bool is_in_front = app.viewer->mode == Mode::analyse && is_in_use(kExplain, app) && !app.shown->run.playing;
  const bool comes = is_in_front && !std::exchange(was_in_front, is_in_front);
  if (!is_in_front) was_in_front = false;
  if (comes && app.viewer->selection.empty()) answer_why_it_jumped(app);
}

std::string remedy_blocked(const Shown& shown) {
  if (simulated_model(shown) == nullptr) return "The layout belongs to the scene: change it in its own file.";
  if (shown.document.editing.project == nullptr) return "The document cannot be edited.";
  return {};
}

void apply_remedy(WindowUi& ui, const Shown& shown, RunAhead& ahead, const Remedy& remedy) {
  const SimFrame& frame = *shown.run.frame;
  ahead = {.phase = RunAhead::Phase::waits_for_model,
           .shows = ShownAfterRun::same_step,
           .without = simulated_model(shown),
           .until = frame.history.last,
           .displayed = frame.step};
  ui.post(EditProject{remedy.edit, {}});
}

}  // namespace taxel::ui
