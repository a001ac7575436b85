#include "ui/panels/interface.h"

#include "ui/panels/bars_panel.h"
#include "ui/panels/dialogs.h"
#include "ui/panels/dock_layout.h"
#include "ui/panels/file_dialog.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/menu_bar.h"
#include "ui/panels/messages.h"
#include "ui/panels/outliner_panel.h"
#include "ui/panels/plot_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/taxel_table_panel.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/toolbar.h"
#include "ui/panels/view_panel.h"
#include "ui/tools/actions.h"
#include "ui/tools/camera_tool.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void draw_section(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kSectionTitle, &ui.saved.panels.section)) section_panel(scene_input(ui, input), ui.section);
  ImGui::End();
}

void draw_panels(UiState& ui, const UiInput& input, SceneRenderer& renderer) {
  draw_view(ui, input, renderer);
  const PanelsShown& shown = ui.saved.panels;
  if (shown.outliner) draw_outliner(ui, input);
  if (shown.taxels) draw_taxel_table(ui, input);
  if (shown.inspector) draw_inspector(ui, input);
  if (shown.bars) draw_bars_panel(ui, input);
  if (shown.plot) draw_plot_panel(ui, input);
  if (shown.section) draw_section(ui, input);
  if (shown.timeline) draw_timeline_panel(ui, input);
  if (shown.messages) draw_messages_panel(ui);
}

}  // namespace

void draw_interface(UiState& ui, const UiInput& input, SceneRenderer& renderer) {
  ui.widgets.begin_frame();
  if (!ui.saved.panels.bars) ui.bars.clear();
  if (ui.summary.model != input.shown_model(ui)) ui.summary = summarize(input.shown_model(ui));
  handle_keys(ui, input);
  draw_menu_bar(ui, input);
  draw_toolbar(ui, input);
  draw_status_line(ui, input);
  draw_dock_space(ui);
  draw_panels(ui, input, renderer);
  draw_help(ui);
  draw_loading(ui, input);
  draw_toasts(ui);
  draw_file_dialog(ui);
  draw_unsaved_question(ui, input);
  draw_recovery_card(ui);
}

}  // namespace taxel::ui
