#include "app/studio/shell/interface/interface.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/explain/hunt.h"
#include "app/studio/nouns/explain/hunt_state.h"
#include "app/studio/shell/interface/dock_layout.h"
#include "app/studio/shell/interface/perform.h"
#include "app/studio/shell/interface/view_window.h"
#include "app/studio/shell/menus/menu_bar.h"
#include "app/studio/shell/menus/palette_card.h"
#include "app/studio/shell/menus/tool_strip.h"
#include "app/studio/shell/menus/toolbar.h"
#include "ui/widgets/keyboard_focus.h"

namespace taxel::ui {

namespace {

/// Calls a member of all rows that have it.
template <auto Feature::*kCall>
void of_each_feature(App& app) {
  for (const Feature* row : features())
    if (row->*kCall != nullptr) (row->*kCall)(app);
}

void draw_panels(App& app, SceneRenderer& renderer) {
  const Arrangement& arrangement = app.get<Arrangement>();
  if (has_room(arrangement, kViewTitle, Dock::inspector)) {
    draw_view(app, renderer);
  } else {
    app.viewer->view.rect = {};
  }
  for (const Feature* row : features())
    if (is_drawn(*row, app) && has_room(arrangement, row->title, row->dock)) row->draw(app);
}

}  // namespace

void draw_interface(App& app, SceneRenderer& renderer) {
  app.ui->widgets.begin_frame();
  of_each_feature<&Feature::begin_frame>(app);
  handle_keys(app);
  draw_menu_bar(app);
  draw_toolbar(app);
  of_each_feature<&Feature::draw_bar>(app);
  draw_dock_space(app);
  of_each_feature<&Feature::update>(app);
  draw_panels(app, renderer);
  of_each_feature<&Feature::end_panels>(app);
  draw_tool_strip(app);
  draw_palette(app);
  of_each_feature<&Feature::draw_card>(app);
  record_keyboard(*app.ui, app.viewer->selection.taxels);
}

void end_demo(App& app) {
  end_demo(*app.ui, app.get<DemoState>());
}

void explain_first_jump(App& app) {
  begin_hunt(*app.ui, app.get<HuntState>());
}

}  // namespace taxel::ui
