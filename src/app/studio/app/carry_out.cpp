#include "app/studio/app/carry_out.h"

#include <algorithm>
#include <cmath>

#include "app/studio/features/perturb/perturb_tool.h"
#include "app/studio/features/scenario/path_tool.h"

namespace taxel::ui {

namespace {

constexpr float kScaleStep = 1.1f, kMinScale = 0.6f, kMaxScale = 2.5f;

}  // namespace

double next_speed(double speed, bool faster) {
  const double notch = std::round(std::log2(speed)) + (faster ? 1 : -1);
  return std::exp2(std::clamp(notch, -4.0, 4.0));
}

void CarryOut::operator()(const Escape&) const {
  if (input.video.active) {
    ui.ask(CancelVideo{});
  } else if (ui.tool.tool != Tool::none) {
    cancel_tool(ui);
  } else if (ui.tour_step >= 0) {
    ui.tour_step = -1;
  } else if (ui.generate.open) {
    close_generate(ui);
  } else if (ui.saved.panels.help) {
    ui.saved.panels.help = false;
  } else if (ui.mesh.pick != FramePick::none) {
    ui.mesh.pick = FramePick::none;
  } else if (ui.measure.on) {
    leave_measure(ui);
  } else if (ui.probe.on) {
    leave_probe(ui);
  } else if (ui.path.held) {
    cancel_way_point_drag(ui);
  } else if (ui.path.selected >= 0 || !ui.selection.taxels.empty() || ui.selection.body >= 0) {
    ui.path.selected = -1;
    ui.selection.clear();
    deselect_body(ui);
  } else {
    free_camera(ui);
  }
}

void CarryOut::operator()(const OpenPalette&) const {
  ui.palette = {};
  ui.palette.open = ui.palette.wants_focus = true;
}

void CarryOut::operator()(const TogglePanel& command) const {
  bool& open = ui.saved.panels.*command.panel;
  flip(open);
  if (open) ui.opened_panel = &open;
}

void CarryOut::operator()(const ScaleInterface& command) const {
  float& scale = ui.saved.scale;
  if (command.steps > 0) scale = std::min(kMaxScale, scale * kScaleStep);
  if (command.steps < 0) scale = std::max(kMinScale, scale / kScaleStep);
  if (command.steps == 0) scale = 1;
}

void CarryOut::operator()(const ResetArrangement&) const {
  ui.saved.panels = PanelsShown{};
  ui.reset_arrangement = true;
}

void CarryOut::operator()(const FrameCamera& command) const {
  free_camera(ui);
  ui.camera().frame(command.selection ? selection_box(ui, input) : scene_box(ui, input));
}

void CarryOut::operator()(const GoToEvent& command) const {
  const std::uint64_t to = next_event(*input.frame->history.lanes, input.frame->step, command.direction);
  if (to != input.frame->step || input.playing) ui.ask(ScrubTo{to});
}

void CarryOut::operator()(const ToggleLoop&) const {
  const HistoryState& history = input.frame->history;
  ui.ask(SetLoop{input.loop ? std::nullopt : std::optional(StepRange{history.first, history.last})});
}

void CarryOut::operator()(const ToggleBreakOnJump&) const {
  Breakpoints breakpoints = input.frame->breakpoints;
  breakpoints.on_jump = !breakpoints.on_jump;
  ui.ask(SetBreakpoints{breakpoints});
}

}  // namespace taxel::ui
