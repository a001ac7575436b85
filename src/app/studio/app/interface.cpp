#include "app/studio/app/interface.h"

#include "app/studio/app/dock_layout.h"
#include "app/studio/app/panels.h"
#include "app/studio/app/perform.h"
#include "app/studio/features/brush/brush_card.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/files/dialogs.h"
#include "app/studio/features/files/file_dialog.h"
#include "app/studio/features/files/file_notices.h"
#include "app/studio/features/menus/menu_bar.h"
#include "app/studio/features/menus/palette_card.h"
#include "app/studio/features/menus/status_line.h"
#include "app/studio/features/menus/toolbar.h"
#include "app/studio/features/menus/tour.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/features/real/real_panel.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/video/video_card.h"
#include "app/studio/features/view/view_panel.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

namespace {

/// Finds the problems of the edited layout, also if it cannot be compiled.
void update_problems(UiState& ui, const UiInput& input) {
  const Editing& editing = input.editing;
  const LayoutProblems& known = ui.problems;
  if (!editing.project || !input.model) {
    ui.problems = {};
  } else if (known.project != editing.project || known.model != input.model || known.compiled != editing.compiled) {
    ui.problems = layout_problems(editing.project, input.model, editing.compiled, editing.mesh_sha256);
  }
}

void draw_panels(UiState& ui, const UiInput& input, SceneRenderer& renderer) {
  draw_view(ui, input, renderer);
  for (const PanelSpec& panel : panels()) {
    const bool shown = panel.shown == nullptr || ui.saved.panels.*panel.shown;
    if (shown && (panel.context != Context::simulate || ui.mode == Mode::simulate)) panel.draw(ui, input);
  }
}

}  // namespace

void draw_interface(UiState& ui, const UiInput& input, SceneRenderer& renderer) {
  ui.widgets.begin_frame();
  if (!ui.saved.panels.bars) ui.bars.clear();
  ui.map.discs.clear();
  if (ui.summary.model != input.shown_model(ui)) ui.summary = summarize(input.shown_model(ui));
  update_problems(ui, input);
  handle_keys(ui, input);
  follow_path_recording(ui, input);
  draw_menu_bar(ui, input);
  draw_toolbar(ui, input);
  draw_status_line(ui, input);
  draw_dock_space(ui, panels());
  follow_scene(ui, input);
  draw_panels(ui, input, renderer);
  draw_brush_card(ui, input);
  draw_palette(ui, input);
  draw_tour(ui);
  draw_help(ui);
  draw_loading(ui, input);
  draw_file_notices(ui);
  draw_toasts(ui);
  draw_video_card(ui, input);
  draw_file_dialog(ui);
  draw_real_dialog(ui, input);
  draw_unsaved_question(ui, input);
  draw_recovery_card(ui);
  record_keyboard(ui, ui.selection.taxels);
}

}  // namespace taxel::ui
