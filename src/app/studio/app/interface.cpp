#include "app/studio/app/interface.h"

#include "app/studio/app/app.h"
#include "app/studio/app/dock_layout.h"
#include "app/studio/app/menus/menu_bar.h"
#include "app/studio/app/menus/palette_card.h"
#include "app/studio/app/menus/tool_strip.h"
#include "app/studio/app/menus/toolbar.h"
#include "app/studio/app/panels.h"
#include "app/studio/app/perform.h"
#include "app/studio/app/pointing/view_window.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/bars/within.h"
#include "app/studio/features/brush/brush_card.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/data_set/replay.h"
#include "app/studio/features/demo/demo.h"
#include "app/studio/features/demo/demo_caption.h"
#include "app/studio/features/explain/hunt.h"
#include "app/studio/features/explain/remedy.h"
#include "app/studio/features/files/dialogs.h"
#include "app/studio/features/files/file_dialog.h"
#include "app/studio/features/files/file_notices.h"
#include "app/studio/features/menus/help.h"
#include "app/studio/features/menus/status_line.h"
#include "app/studio/features/menus/tour.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/features/real/real_panel.h"
#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/timeline/timeline_panel.h"
#include "app/studio/features/video/video_card.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

namespace {

/// Finds the problems of the edited layout, also if it cannot be compiled.
void update_problems(App& app) {
  const Editing& editing = app.shown->document.editing;
  const LayoutProblems& known = app.layout->problems;
  if (!editing.project || !app.shown->document.model) {
    app.layout->problems = {};
  } else if (known.project != editing.project || known.model != app.shown->document.model ||
             known.compiled != editing.compiled) {
    app.layout->problems =
        layout_problems(editing.project, app.shown->document.model, editing.compiled, editing.mesh_sha256);
  }
}

void draw_panels(App& app, SceneRenderer& renderer) {
  const Arrangement& arrangement = app.window->arrangement;
  if (has_room(arrangement, kViewTitle, Dock::inspector)) {
    draw_view(app, renderer);
  } else {
    app.viewer->view.rect = {};
  }
  for (const PanelSpec& panel : panels())
    if (panel.draw != nullptr && is_drawn(panel, app) && has_room(arrangement, panel.title, panel.dock))
      panel.draw(app);
}

}  // namespace

void draw_interface(App& app, SceneRenderer& renderer) {
  app.ui->widgets.begin_frame();
  app.simulate->bars.clear();
  app.simulate->map.discs.clear();
  app.simulate->plot.shown = {};
  app.simulate->heat.shown = {};
  app.simulate->compare.shown = {};
  if (app.layout->summary.model != app.shown->model(*app.viewer))
    app.layout->summary = summarize(app.shown->model(*app.viewer));
  update_problems(app);
  handle_keys(app);
  follow_path_recording(*app.ui, *app.viewer, *app.shown, app.simulate->perturb, app.simulate->path,
                        app.window->messages);
  draw_menu_bar(app);
  draw_toolbar(app);
  draw_status_line(*app.ui, *app.viewer, *app.shown, app.window->arrangement, app.window->messages);
  draw_message_line(*app.ui, app.window->panels, app.window->messages);
  draw_timeline(*app.ui, *app.viewer, *app.shown, app.simulate->timeline, app.window->arrangement.timeline_rows,
                app.window->panels.timeline);
  draw_dock_space(app, panels());
  follow_replay(*app.shown, app.simulate->data_set);
  follow_scene(*app.viewer, app.shown->run, app.simulate->follow);
  advance_demo(*app.ui, *app.viewer, app.shown->run, app.window->demo, ImGui::GetIO().DeltaTime);
  draw_panels(app, renderer);
  follow_hunt(*app.viewer, *app.shown, app.simulate->hunt, app.simulate->explain, app.window->panels.explain);
  keep_within(*app.ui, *app.shown, app.simulate->error_bars);
  rerun_after_remedy(*app.ui, *app.shown, app.simulate->explain);
  draw_tool_strip(app);
  if (app.window->tour.step < 0) draw_demo_caption(*app.ui, *app.viewer, app.window->demo);
  draw_brush_card(*app.ui, *app.viewer, *app.shown, app.layout->tool);
  draw_palette(app);
  draw_tour(*app.ui, app.window->tour);
  draw_help(*app.ui, app.window->panels, app.window->help);
  draw_loading(*app.ui, app.viewer->view, app.shown->document);
  draw_file_notices(*app.ui, app.viewer->view, app.window->notices);
  draw_video_card(*app.ui, app.viewer->view, app.simulate->video);
  draw_file_dialog(*app.ui, app.simulate->controls, app.simulate->video, app.window->dialog);
  draw_real_dialog(*app.ui, *app.viewer, *app.shown, app.simulate->real);
  draw_unsaved_question(*app.ui, app.shown->document, app.window->asks_unsaved);
  draw_recovery_card(*app.ui, app.window->recovery);
  record_keyboard(*app.ui, app.viewer->selection.taxels);
}

void end_demo(App& app) {
  end_demo(*app.ui, app.window->demo);
}

void explain_first_jump(App& app) {
  begin_hunt(*app.ui, app.simulate->hunt);
}

}  // namespace taxel::ui
