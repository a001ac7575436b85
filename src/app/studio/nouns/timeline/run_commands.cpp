#include "app/studio/nouns/timeline/run_commands.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/present/present.h"
#include "core/base/error.h"

namespace taxel::ui {

double next_speed(double speed, bool faster) {
  const double notch = std::round(std::log2(speed)) + (faster ? 1 : -1);
  return std::exp2(std::clamp(notch, -4.0, 4.0));
}

void carry_out(const GoToEvent& command, App& app) {
  const std::uint64_t to =
      next_event(*app.shown->run.frame->history.lanes, app.shown->run.frame->step, command.direction);
  if (to != app.shown->run.frame->step || app.shown->run.playing) carry_out(ShowEvent{to}, app);
}

void carry_out(const ShowEvent& command, App& app) {
  const SimFrame& frame = *app.shown->run.frame;
  const HistoryLanes& lanes = *frame.history.lanes;
  app.ui->post(ScrubTo{command.step});
  const std::size_t row = lanes.row_of(command.step);
  for (std::size_t s = 0; s < lanes.sensor_count; ++s) {
    const SensorSummary& sensor = lanes.sensor(row, s);
    const SensorModelPtr& model = frame.scene->sensors[s];
    if (!sensor.is_jump || !model || static_cast<std::size_t>(sensor.jumped_taxel) >= model->layout.taxels.size())
      continue;
    const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(sensor.jumped_taxel)];
    return click_taxel_of(app.viewer->selection, {static_cast<int>(s), taxel.id}, false);
  }
}

void carry_out(const GoToNewestStep&, App& app) {
  app.ui->post(ScrubTo{app.shown->run.frame->history.last});
}

void carry_out(const TogglePlayBackwards&, App& app) {
  app.ui->post(ReplayHistory{app.shown->run.replay < 0 ? 0 : -1});
}

void carry_out(const ToggleLoop&, App& app) {
  const HistoryState& history = app.shown->run.frame->history;
  app.ui->post(SetLoop{app.shown->run.loop ? std::nullopt : std::optional(StepRange{history.first, history.last})});
}

void carry_out(const ToggleBreakOnJump&, App& app) {
  Breakpoints breakpoints = app.shown->run.frame->breakpoints;
  breakpoints.on_jump = !breakpoints.on_jump;
  app.ui->post(BreakpointsCommand{breakpoints});
}

void carry_out(const ToggleRecording&, App& app) {
  app.ui->post(SetRecording{!app.shown->run.frame->recording.on});
}

void carry_out(const ChangeSpeed& c, App& app) {
  app.ui->post(SetSpeed{next_speed(app.shown->run.speed, c.faster)});
}

}  // namespace taxel::ui

namespace taxel::studio {

namespace {

bool run_scenario(Host& host, const Scenario& scenario) {
  const std::optional<LoadedDocument>& document = host.document.opened();
  if (!document || !document->model || document->model->taxel_count() == 0) return false;
  if (document->kind == DocumentKind::scene) return false;
  if (!host.edits().problem().empty()) {
    host.report(Severity::error, document->name + ": " + host.edits().problem(), ui::Holds::while_unrunnable);
    return false;
  }
  if (host.edits().is_open()) host.edits().edit(SetScenario{scenario});
  if (document->previewed()) host.handover.request();
  const auto place_of = [](const Scenario& s) { return find_number(s, "place") ? *find_number(s, "place") : 0.0; };
  const RunningScene& scene = host.run.scene;
  const bool elsewhere = !scene.is_of_document || scenario.kind() != scene.scenario.kind() ||
                         place_of(scenario) != place_of(scene.scenario);
  build_scene(
      host.run,
      {.document = *document, .is_scenario = true, .scenario = scenario, .plays = true, .turns_cameras = elsewhere});
  return true;
}

bool run_or_say_why_not(Host& host) {
  if (run_scenario(host, host.scenario())) return true;
  if (host.app.shown->document.model && host.app.shown->document.model->taxel_count() == 0)
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                    "Nothing to simulate: the layout has no taxels. Ctrl+click on the mesh places a taxel, Ctrl+G "
                    "generates a pattern.",
                    ImGui::GetTime(), ui::Holds::while_unrunnable);
  return false;
}

}  // namespace

bool can_play_or_report(Host& host) {
  if (host.run.scene.is_still)
    host.report(Severity::error, host.document.opened()->name + " is a single step: there is nothing to run.",
                ui::Holds::for_document);
  return host.run.can_play();
}

void set_playing(Host& host, bool plays) {
  if (can_play_or_report(host)) set_playing(host.run, plays, host.handover.will_change_samples());
}

void scrub(Host& host, std::uint64_t step) {
  if (can_play_or_report(host)) scrub(host.run, step);
}

void rest_in_layout(Host& host) {
  if (ui::shows_run(host.app.viewer->mode)) {
    if (std::exchange(host.rests_in_layout, false)) set_playing(host, true);
  } else if (host.run.moves()) {
    host.rests_in_layout = host.run.playback.plays;
    set_playing(host, false);
  }
}

void carry_out(const ui::RunScenario& command, Host& host) {
  run_scenario(host, command.scenario);
}

/// In LAYOUT nothing is simulated: the run goes on in SIMULATE.
void carry_out(const ui::PlayOrPause&, Host& host) {
  if (host.app.viewer->mode == ui::Mode::layout) {
    carry_out(ui::SetMode{ui::Mode::simulate}, host);
    if (ui::shows_run(host.app.viewer->mode) && host.run.scene.is_shown()) set_playing(host, true);
    return;
  }
  if (!host.run.scene.is_shown() && !run_or_say_why_not(host)) return;
  host.handover.request();
  set_playing(host, !host.run.moves());
}

void carry_out(const ui::StepOnce&, Host& host) {
  if (can_play_or_report(host)) step_by(host.run, 1, host.handover.will_change_samples());
}

void carry_out(const ui::StepBack&, Host& host) {
  if (can_play_or_report(host)) step_by(host.run, -1, host.handover.will_change_samples());
}

void carry_out(const ui::StepAhead& command, Host& host) {
  if (can_play_or_report(host)) step_ahead(host.run, command.steps);
}

void carry_out(const ui::ScrubTo& command, Host& host) {
  scrub(host, command.step);
}

void carry_out(const ui::ReplayHistory& command, Host& host) {
  if (can_play_or_report(host)) replay(host.run, command.direction);
}

void carry_out(const ui::SetLoop& command, Host& host) {
  host.run.cursor.loop = command.range;
}

void carry_out(const ui::SetRecording& command, Host& host) {
  if (!can_play_or_report(host)) return;
  command.on
      ? host.run.simulation->send(RecordCommand{free_name("recording-", ""), host.app.get<ui::ErrorBarsState>().on})
      : host.run.simulation->send(EndRecordingCommand{});
}

void carry_out(const ui::ResetSimulation&, Host& host) {
  if (can_play_or_report(host)) reset_run(host.run);
}

void carry_out(const ui::SetSpeed& command, Host& host) {
  set_speed(host.run, command.factor);
}

void carry_out(const ui::SetMode& command, Host& host) {
  const ui::Mode mode = command.mode;
  const bool was_shown = host.run.scene.is_shown();
  const bool runs = host.run.scene.is_shown() || host.run.frame != nullptr;
  if (ui::shows_run(mode) && !host.run.scene.is_shown() && !run_or_say_why_not(host) && !runs) return;
  if (ui::shows_run(mode)) host.handover.request();
  host.app.get<ui::Framing>().checks_view = host.app.get<ui::Framing>().checks_view || host.app.viewer->mode != mode;
  ui::enter_mode(host.app, mode);
  if (mode == ui::Mode::analyse) ui::show_all_parts(host.app);
  if (mode == ui::Mode::analyse && was_shown) host.rests_in_layout = false;  // the recorded steps are analysed
  rest_in_layout(host);
  if (mode == ui::Mode::analyse && was_shown && command.pauses && host.run.moves()) set_playing(host, false);
}

}  // namespace taxel::studio
