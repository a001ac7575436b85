// The window around the panels: its theme, its title, its tool rows and the arrangement of the panels.
#pragma once

#include <string>

namespace taxel::ui {

/// Kept in the settings file.
struct Appearance {
  bool dark = true;
  float scale = 1.0f;  ///< scale of the interface, in addition to the screen's own
};

struct Arrangement {
  double scale = 0;                       ///< scale for which the panels were arranged, or 0 before that
  bool reset = false;                     ///< whether the panels are to be arranged again
  int toolbar_rows = 1, status_rows = 1;  ///< rows that they needed in the previous frame
};

}  // namespace taxel::ui
