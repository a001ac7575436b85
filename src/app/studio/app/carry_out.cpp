#include "app/studio/app/carry_out.h"

#include <algorithm>
#include <cmath>

#include "app/studio/app/dock_layout.h"
#include "app/studio/app/panels.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {

namespace {

constexpr float kScaleStep = 1.1f, kMinScale = 0.6f, kMaxScale = 2.5f;

}  // namespace

double next_speed(double speed, bool faster) {
  const double notch = std::round(std::log2(speed)) + (faster ? 1 : -1);
  return std::exp2(std::clamp(notch, -4.0, 4.0));
}

void CarryOut::operator()(const OpenPalette&) const {
  app.window->palette = {};
  app.window->palette.open = app.window->palette.wants_focus = true;
}

void CarryOut::operator()(const TogglePanel& command) const {
  bool& open = command.panel(app);
  flip(open);
  if (open) app.ui->opened_panel = &open;
  app.window->arrangement.maximised.clear();
}

void CarryOut::operator()(const ScaleInterface& command) const {
  float& scale = app.window->appearance.scale;
  if (command.steps > 0) scale = std::min(kMaxScale, scale * kScaleStep);
  if (command.steps < 0) scale = std::max(kMinScale, scale / kScaleStep);
  if (command.steps == 0) scale = 1;
}

void CarryOut::operator()(const ResetArrangement&) const {
  App fresh;
  for (const PanelSpec& panel : panels())
    if (panel.shown != nullptr) panel.shown(app) = panel.shown(fresh);
  info_switch(app) = help_switch(app) = false;
  app.window->arrangement.kept = {};
  app.window->arrangement.reset = true;
}

void CarryOut::operator()(const MaximisePanel&) const {
  toggle_maximised(app.window->arrangement, panels());
}

void CarryOut::operator()(const ProbeInLayout&) const {
  app.ui->post(SetMode{Mode::layout});
  if (!app.layout->probe.on) app.ui->post(ToggleProbe{});
}

void CarryOut::operator()(const FrameCamera& command) const {
  free_camera(*app.viewer, app.simulate->follow);
  app.viewer->camera().frame(command.selection ? selection_box(*app.viewer, *app.shown)
                                               : scene_box(*app.viewer, *app.shown));
}

void CarryOut::operator()(const GoToEvent& command) const {
  const std::uint64_t to =
      next_event(*app.shown->run.frame->history.lanes, app.shown->run.frame->step, command.direction);
  if (to != app.shown->run.frame->step || app.shown->run.playing) app.ui->post(ScrubTo{to});
}

void CarryOut::operator()(const ToggleLoop&) const {
  const HistoryState& history = app.shown->run.frame->history;
  app.ui->post(SetLoop{app.shown->run.loop ? std::nullopt : std::optional(StepRange{history.first, history.last})});
}

void CarryOut::operator()(const ToggleBreakOnJump&) const {
  Breakpoints breakpoints = app.shown->run.frame->breakpoints;
  breakpoints.on_jump = !breakpoints.on_jump;
  app.ui->post(SetBreakpoints{breakpoints});
}

}  // namespace taxel::ui
