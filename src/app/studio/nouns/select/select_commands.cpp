#include "app/studio/nouns/select/select_commands.h"

#include "app/studio/frame/app.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scene/controls_state.h"

namespace taxel::ui {

namespace {

/// Removes hidden taxels from the selection.
void keep_shown(App& app) {
  if (app.viewer->mode != Mode::layout || !app.shown->document.editing.project) return;
  for (const int id : app.shown->document.editing.project->hidden) app.viewer->selection.remove(id);
}

}  // namespace

void carry_out(const SelectAll&, App& app) {
  app.viewer->selection.set_all(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void carry_out(const SelectNone&, App& app) {
  app.viewer->selection.clear();
}

void carry_out(const InvertSelection&, App& app) {
  app.viewer->selection.invert(*app.shown->layout(*app.viewer));
  keep_shown(app);
}

void carry_out(const SelectParentBody&, App& app) {
  select_parent(*app.ui, app.viewer->selection, app.shown->run, app.get<PerturbState>(), app.get<ControlsState>());
}

}  // namespace taxel::ui
