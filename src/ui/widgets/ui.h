// The state that every widget of the interface needs.
#pragma once

#include "ui/widgets/field_state.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// State of the widgets, passed to every function that draws one.
struct Ui {
  WidgetRegistry widgets;
  FieldState fields;
  bool dark = true;                    ///< theme of this frame
  double pixel_scale = 1;              ///< scale of the interface: the user's scale times the screen's
  const bool* opened_panel = nullptr;  ///< open flag of the panel that gets to the front next frame, or null
};

}  // namespace taxel::ui
