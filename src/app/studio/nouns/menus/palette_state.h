// The state of the command palette: the typed text and the chosen command.
#pragma once

#include <string>

namespace taxel::ui {

struct PaletteState {
  bool open = false;
  bool wants_focus = false;  ///< whether the text field gets the keyboard in the next frame
  std::string typed;
  int chosen = 0;  ///< index in the displayed list
};

}  // namespace taxel::ui
