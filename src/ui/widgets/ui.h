// The state that every widget of the interface needs.
#pragma once

#include "ui/widgets/field_state.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

struct Ui {
  WidgetRegistry widgets;
  FieldState fields;
  bool dark = true;                    ///< theme of this frame
  double pixel_scale = 1;              ///< scale of the interface in this window: the user's times the screen's
  const bool* opened_panel = nullptr;  ///< switch of the panel that comes to the front in the next frame, or null
};

}  // namespace taxel::ui
