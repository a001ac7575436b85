#include "app/studio/shell/interface/tools.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/viewer.h"

namespace taxel::ui {

namespace {

bool is_valid(Context context, Mode mode) {
  return context == kEverywhere || (context == kLayout) == (mode == Mode::layout);
}

}  // namespace

void handle_view_mouse(App& app) {
  const PointerEvent event = read_pointer(app.viewer->view);
  app.viewer->hovered.reset();
  for (const Feature* row : features()) {
    const ToolSpec& tool = row->tool;
    if (tool.pointer != nullptr && is_valid(tool.context, app.viewer->mode) && tool.pointer(app, event)) return;
  }
}

}  // namespace taxel::ui
