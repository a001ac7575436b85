// The state of the menu bar under the keyboard.
#pragma once

namespace taxel::ui {

struct MenuKeys {
  bool on = false;          ///< whether the menu bar has the keyboard
  int menu = 0;             ///< index of the marked or open menu
  int asked = -1;           ///< index of the menu that opens in this frame, or -1
  bool open = false;        ///< whether a menu of the bar is open
  bool on_submenu = false;  ///< whether the marked entry is the title of a submenu
  bool alt_alone = false;   ///< whether Alt went down, and no other key or button since
  int before = 0;           ///< number of open popups at the begin of the last frame
  int after = 0;            ///< number of open popups after the menus of the last frame
  unsigned window = 0;      ///< ImGui's id of the window that had the keyboard before, or 0
};

}  // namespace taxel::ui
