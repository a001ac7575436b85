// The whole state of the window: a plain value. Only the files of app/studio/app see it; panels and tools take parts.
#pragma once

#include "app/studio/app/features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {

struct App {
  WindowUi ui;
  Viewer viewer;
  Shown shown;
  LayoutFeatures layout;
  SimulateFeatures simulate;
  WindowFeatures window;
};

}  // namespace taxel::ui
