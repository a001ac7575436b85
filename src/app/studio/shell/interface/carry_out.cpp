#include "app/studio/shell/interface/carry_out.h"

#include <algorithm>
#include <cmath>

#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/menus/palette_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/shell/interface/dock_layout.h"

namespace taxel::ui {

namespace {

constexpr float kScaleStep = 1.1f, kMinScale = 0.6f, kMaxScale = 2.5f;

}  // namespace

double next_speed(double speed, bool faster) {
  const double notch = std::round(std::log2(speed)) + (faster ? 1 : -1);
  return std::exp2(std::clamp(notch, -4.0, 4.0));
}

void CarryOut::operator()(const OpenPalette&) const {
  app.get<PaletteState>() = {};
  app.get<PaletteState>().open = app.get<PaletteState>().wants_focus = true;
}

void CarryOut::operator()(const TogglePanel& command) const {
  bool& open = app.get<PanelsShown>()[*command.panel];
  flip(open);
  if (open) app.ui->opened_panel = &open;
  app.get<Arrangement>().maximised.clear();
}

void CarryOut::operator()(const ScaleInterface& command) const {
  float& scale = app.get<Appearance>().scale;
  if (command.steps > 0) scale = std::min(kMaxScale, scale * kScaleStep);
  if (command.steps < 0) scale = std::max(kMinScale, scale / kScaleStep);
  if (command.steps == 0) scale = 1;
}

void CarryOut::operator()(const ResetArrangement&) const {
  for (const Feature* row : features()) app.get<PanelsShown>()[*row] = row->open;
  app.get<Arrangement>().kept = {};
  app.get<Arrangement>().reset = true;
}

void CarryOut::operator()(const MaximisePanel&) const {
  toggle_maximised(app.get<Arrangement>());
}

void CarryOut::operator()(const ProbeInLayout&) const {
  app.ui->post(SetMode{Mode::layout});
  if (!app.get<ProbeState>().on) app.ui->post(ToggleProbe{});
}

void CarryOut::operator()(const FrameCamera& command) const {
  free_camera(*app.viewer, app.get<FollowState>());
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
