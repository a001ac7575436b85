// The window around the panels: its theme, its title, its tool rows and the arrangement of the panels.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace taxel::ui {

/// Kept in the settings file.
struct Appearance {
  bool dark = true;
  float scale = 1.0f;  ///< scale of the interface, in addition to the screen's own
};

/// Each mode has an arrangement of its own. Only the arrangement of the displayed mode exists in ImGui; the other one
/// is kept as a text, which is also the text of its file.
struct Arrangement {
  double scale = 0;                       ///< scale for which the panels were arranged, or 0 before that
  bool reset = false;                     ///< whether the panels are to be arranged again
  int toolbar_rows = 1, status_rows = 1;  ///< rows that they needed in the previous frame
  int timeline_rows = 1;                  ///< rows of the timeline's buttons in the previous frame
  std::array<std::string, 2> kept;        ///< arrangements of LAYOUT and SIMULATE, or empty for a new one
  std::optional<std::size_t> displayed;   ///< index in `kept` of the displayed arrangement
  std::string maximised;                  ///< title of the panel that is to fill the window, or empty
  std::string filling;                    ///< title of the panel that fills the window now, or empty
  float width = 0, height = 0;            ///< size of the window [pixels]
};

}  // namespace taxel::ui
