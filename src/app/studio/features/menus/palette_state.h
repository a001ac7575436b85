// The command palette: what is typed, and which of the commands found is chosen.
#pragma once

#include <string>

namespace taxel::ui {

struct PaletteState {
  bool open = false;
  bool wants_focus = false;  ///< its field gets the keyboard in the next picture
  std::string typed;
  int chosen = 0;  ///< in the list shown
};

}  // namespace taxel::ui
