#include "app/studio/app/interface.h"

#include "app/studio/app/actions.h"
#include "app/studio/app/camera_tool.h"
#include "app/studio/app/dock_layout.h"
#include "app/studio/features/bars/bars_panel.h"
#include "app/studio/features/brush/brush_card.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/explain/explain_panel.h"
#include "app/studio/features/files/dialogs.h"
#include "app/studio/features/files/file_dialog.h"
#include "app/studio/features/files/file_notices.h"
#include "app/studio/features/generate/generate_panel.h"
#include "app/studio/features/inspector/inspector_panel.h"
#include "app/studio/features/inspector/outliner_panel.h"
#include "app/studio/features/map/map_panel.h"
#include "app/studio/features/menus/menu_bar.h"
#include "app/studio/features/menus/palette_card.h"
#include "app/studio/features/menus/status_line.h"
#include "app/studio/features/menus/toolbar.h"
#include "app/studio/features/menus/tour.h"
#include "app/studio/features/mesh/mesh_section.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/features/models/models_panel.h"
#include "app/studio/features/plot/plot_panel.h"
#include "app/studio/features/profiler/profiler_panel.h"
#include "app/studio/features/real/real_panel.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/scene/controls_panel.h"
#include "app/studio/features/study/study_panel.h"
#include "app/studio/features/table/taxel_table_panel.h"
#include "app/studio/features/timeline/timeline_panel.h"
#include "app/studio/features/video/video_card.h"
#include "app/studio/features/view/view_panel.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

namespace {

void draw_section(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kSectionTitle, &ui.saved.panels.section)) section_panel(scene_input(ui, input), ui.section);
  ImGui::End();
}

/// What is wrong is told of the layout as it is, also where it cannot be compiled.
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
  const PanelsShown& shown = ui.saved.panels;
  if (shown.outliner) draw_outliner(ui, input);
  if (shown.taxels) draw_taxel_table(ui, input);
  if (shown.inspector) draw_inspector(ui, input);
  if (shown.controls && ui.mode == Mode::simulate) draw_controls_panel(ui, input);
  if (shown.bars) draw_bars_panel(ui, input);
  if (shown.map) draw_map_panel(ui, input);
  if (shown.plot) draw_plot_panel(ui, input);
  if (shown.section) draw_section(ui, input);
  if (shown.timeline && ui.mode == Mode::simulate) draw_timeline_panel(ui, input);
  if (shown.explain && ui.mode == Mode::simulate) draw_explain_panel(ui, input);
  draw_real_panel(ui, input);
  if (shown.models && ui.mode == Mode::simulate) draw_models_panel(ui, input);
  if (shown.study && ui.mode == Mode::simulate) draw_study_panel(ui, input);
  if (shown.profiler) draw_profiler_panel(ui, input);
  if (shown.messages) draw_messages_panel(ui);
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
  draw_dock_space(ui);
  follow_scene(ui, input);
  draw_panels(ui, input, renderer);
  draw_brush_card(ui, input);
  draw_generate_panel(ui, input);
  draw_palette(ui, input);
  draw_tour(ui);
  draw_help(ui);
  draw_mesh_report(ui, input);
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
