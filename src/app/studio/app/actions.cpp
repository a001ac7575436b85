#include "app/studio/app/actions.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/dock_layout.h"
#include "app/studio/app/edit_actions.h"
#include "app/studio/app/view_actions.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/perturb/perturb_tool.h"
#include "app/studio/features/probe/probe_tool.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/studio/features/taxel/gesture.h"
#include "app/studio/features/timeline/time_actions.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

namespace {

/// The switch that an action turns, or null.
bool* switch_of(Action action, SavedState& saved) {
  if (bool* overlay = overlay_switch(action, saved.overlays)) return overlay;
  switch (action) {
    case Action::toggle_outliner:
      return &saved.panels.outliner;
    case Action::toggle_taxel_table:
      return &saved.panels.taxels;
    case Action::toggle_inspector:
      return &saved.panels.inspector;
    case Action::toggle_bars:
      return &saved.panels.bars;
    case Action::toggle_plots:
      return &saved.panels.plot;
    case Action::toggle_timeline:
      return &saved.panels.timeline;
    case Action::toggle_explain:
      return &saved.panels.explain;
    case Action::toggle_map:
      return &saved.panels.map;
    case Action::toggle_models:
      return &saved.panels.models;
    case Action::toggle_study:
      return &saved.panels.study;
    case Action::toggle_section:
      return &saved.panels.section;
    case Action::toggle_controls:
      return &saved.panels.controls;
    case Action::toggle_messages:
      return &saved.panels.messages;
    case Action::toggle_mesh_report:
      return &saved.panels.mesh_report;
    case Action::toggle_info:
      return &saved.panels.info;
    case Action::toggle_profiler:
      return &saved.panels.profiler;
    case Action::help:
      return &saved.panels.help;
    default:
      return nullptr;
  }
}

void escape(UiState& ui) {
  if (ui.tool.tool != Tool::none) {
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

bool counts(Context context, const UiState& ui, bool gesture) {
  switch (context) {
    case Context::gesture:
      return gesture;
    case Context::widget:
      return false;  // the widget's own business
    case Context::layout:
      return !gesture && ui.mode == Mode::layout;
    case Context::simulate:
      return !gesture && ui.mode == Mode::simulate;
    case Context::everywhere:
      return !gesture;
  }
  return false;
}

constexpr float kScaleStep = 1.1f, kLeastScale = 0.6f, kLargestScale = 2.5f;

bool perform_on_interface(Action action, UiState& ui) {
  switch (action) {
    case Action::escape:
      escape(ui);
      return true;
    case Action::walk_panels:
      enter_panel(ui, kInspectorTitle);
      return true;
    case Action::walk_panels_back:
      enter_panel(ui, kTaxelsTitle);
      return true;
    case Action::palette:
      ui.palette = {};
      ui.palette.open = ui.palette.wants_focus = true;
      return true;
    case Action::tour:
      ui.tour_step = 0;
      return true;
    case Action::lock_range:
      ui.range.automatic = !ui.range.automatic;
      return true;
    case Action::toggle_theme:
      ui.saved.dark = !ui.saved.dark;
      return true;
    case Action::scale_up:
      ui.saved.scale = std::min(kLargestScale, ui.saved.scale * kScaleStep);
      return true;
    case Action::scale_down:
      ui.saved.scale = std::max(kLeastScale, ui.saved.scale / kScaleStep);
      return true;
    case Action::scale_reset:
      ui.saved.scale = 1.0f;
      return true;
    case Action::full_screen:
      ui.full_screen = !ui.full_screen;
      return true;
    case Action::reset_arrangement:
      ui.saved.panels = PanelsShown{};
      ui.reset_arrangement = true;
      return true;
    default:
      break;
  }
  bool* value = switch_of(action, ui.saved);
  if (value == nullptr) return false;
  *value = !*value;
  if (*value) ui.opened_panel = value;
  return true;
}

}  // namespace

double next_speed(double speed, bool faster) {
  const double notch = std::round(std::log2(speed)) + (faster ? 1 : -1);
  return std::exp2(std::clamp(notch, -4.0, 4.0));
}

void click_taxel(UiState& ui, int id, bool shift) {
  shift ? ui.selection.toggle(id) : ui.selection.set(id);
}

void add_message(UiState& ui, Severity severity, std::string text, double now) {
  Message message;
  message.severity = severity;
  message.text = std::move(text);
  message.number = ui.messages.empty() ? 1 : ui.messages.back().number + 1;
  message.shown_at = now;
  ui.messages.push_back(std::move(message));
}

void begin_dialog(UiState& ui, FileTask task) {
  ui.dialog.task = task;
  ui.dialog.open = ui.dialog.wants_focus = true;
  ui.dialog.path.clear();
  ui.dialog.filter.clear();
  ui.dialog.exists.clear();
}

void open_dialog(UiState& ui) {
  begin_dialog(ui, FileTask::open);
  ui.ask(ListFolder{ui.dialog.folder});
}

void perform(Action action, UiState& ui, const UiInput& input) {
  if (action == Action::escape && input.video.active) return ui.ask(CancelVideo{});
  if (!is_enabled(action, ui, input) || perform_on_interface(action, ui) || perform_edit(action, ui, input) ||
      perform_in_time(action, ui, input) || perform_on_view(action, ui, input))
    return;
  switch (action) {
    case Action::open_file:
      open_dialog(ui);
      break;
    case Action::open_sweep:
      ui.ask(OpenFingertipSweep{});
      break;
    case Action::reload_file:
      ui.ask(ReloadFile{});
      break;
    case Action::close_document:
      ui.ask(CloseDocument{});
      break;
    case Action::screenshot:
      ui.ask(TakeScreenshot{});
      break;
    case Action::quit:
      ui.ask(Quit{});
      break;
    case Action::play_pause:
      ui.ask(PlayOrPause{});
      break;
    case Action::reset_simulation:
      ui.ask(ResetSimulation{});
      break;
    case Action::slower:
      ui.ask(SetSpeed{next_speed(input.speed, false)});
      break;
    case Action::faster:
      ui.ask(SetSpeed{next_speed(input.speed, true)});
      break;
    case Action::mode_layout:
      ui.ask(SetMode{Mode::layout});
      break;
    case Action::mode_simulate:
      ui.ask(SetMode{Mode::simulate});
      break;
    case Action::probe:
      toggle_probe(ui, input);
      break;
    case Action::measure:
      toggle_measure(ui, input);
      break;
    default:
      break;
  }
}

bool is_checked(Action action, const UiState& ui) {
  if (action == Action::toggle_theme) return !ui.saved.dark;
  if (action == Action::lock_range) return !ui.range.automatic;
  if (action == Action::record_path) return ui.path.recording.has_value();
  if (action == Action::probe) return ui.probe.on;
  if (action == Action::measure) return ui.measure.on;
  if (action == Action::toggle_clip) return ui.clip.has_value();
  if (action == Action::mode_layout) return ui.mode == Mode::layout;
  if (action == Action::full_screen) return ui.full_screen;
  if (action == Action::cycle_frames) return ui.saved.overlays.frames != FramesShown::none;
  if (action == Action::cycle_labels) return ui.saved.overlays.labels != LabelsShown::none;
  if (action == Action::mode_simulate) return ui.mode == Mode::simulate;
  SavedState saved = ui.saved;
  const bool* value = switch_of(action, saved);
  return value != nullptr && *value;
}

bool is_enabled(Action action, const UiState& ui, const UiInput& input) {
  if (const std::optional<bool> view = is_view_enabled(action, ui, input)) return *view;
  switch (action) {
    case Action::play_pause:
      return input.frame != nullptr || input.model != nullptr;  // without taxels a message says what is missing
    case Action::step_forward:
    case Action::reset_simulation:
      return input.frame != nullptr || (input.model && input.model->taxel_count() > 0);
    case Action::step_back:
    case Action::next_event:
    case Action::previous_event:
    case Action::newest_step:
    case Action::play_backwards:
    case Action::loop_range:
    case Action::break_on_jump:
    case Action::explain:
    case Action::record:
      return has_history(input);
    case Action::record_path:
      return can_record_path(ui, input);
    case Action::mode_layout:
    case Action::close_document:
      return input.model != nullptr || input.frame != nullptr;
    case Action::mode_simulate:
      return input.frame != nullptr || input.model != nullptr;
    case Action::probe:
    case Action::measure:
      return can_probe(ui, input);
    case Action::reload_file:
      return !input.file.empty();
    default:
      return is_edit_enabled(action, ui, input);
  }
}

void handle_keys(UiState& ui, const UiInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  if (ui.fields.had_keys || io.WantTextInput) return;
  // What a gesture has begun with takes all keys until it ends, which may be within this loop.
  const bool gesture = ui.tool.follows();
  if (gesture) type_number(ui);
  for (const Binding& b : bindings()) {
    if (!counts(b.context, ui, gesture)) continue;
    for (const int chord : {b.chord, b.also}) {
      // While a gesture runs, Shift and Ctrl are its own: they make it finer, and snap.
      if (chord != 0 && !widgets_take(ui, chord) && (gesture || io.KeyMods == (chord & ImGuiMod_Mask_)) &&
          ImGui::IsKeyPressed(static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_), b.repeats)) {
        perform(b.action, ui, input);
      }
    }
  }
}

}  // namespace taxel::ui
