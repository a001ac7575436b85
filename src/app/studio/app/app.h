// The whole state of the window: a plain value. Only the files of app/studio/app see it; panels and tools take parts.
#pragma once

#include "app/studio/app/values/indirect.h"

namespace taxel::ui {

struct WindowUi;
struct Viewer;
struct Shown;
struct LayoutFeatures;
struct SimulateFeatures;
struct WindowFeatures;

/// A file that uses a part includes the part's header, so that a change of one part compiles only its users again.
struct App {
  Indirect<WindowUi> ui;                ///< values/window_ui.h
  Indirect<Viewer> viewer;              ///< values/viewer.h
  Indirect<Shown> shown;                ///< values/shown.h
  Indirect<LayoutFeatures> layout;      ///< values/layout_features.h
  Indirect<SimulateFeatures> simulate;  ///< values/simulate_features.h
  Indirect<WindowFeatures> window;      ///< values/window_features.h
};

}  // namespace taxel::ui
