#include "app/studio/shell/reset.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

void forget_document(App& app) {
  app.ui->fields.refused.reset();
  app.viewer->selection = {};
  app.viewer->clip.reset();
  app.states.forget_document();
}

}  // namespace taxel::ui
