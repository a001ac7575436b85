// The menus by keyboard: Alt or F10 marks the first menu, arrows walk, a letter or Enter opens, Esc closes.
#pragma once

#include <span>

#include "app/studio/nouns/menus/menu_keys_state.h"

namespace taxel::ui {

/// Reads the keys of this frame and decides which menu is marked, opened or closed. Call it in the window of the menu
/// bar, before its menus are drawn. `menus` are the titles from left to right, each with another first letter. `free`
/// is false while a field, a gesture or a dialog has the keyboard: then the menus do not take it.
void read_menu_keys(MenuKeys& keys, std::span<const char* const> menus, bool free);

/// Opens menu `index` if a key asked for it. Call it before the menu is begun.
void open_if_asked(MenuKeys& keys, const char* title, int index);

/// Marks the title of menu `index`, which was drawn last, if it is the keyboard's. `open` says whether the menu is
/// open.
void mark_menu(MenuKeys& keys, int index, bool open);

/// Takes notes about a submenu whose title was drawn last.
void note_submenu(MenuKeys& keys);

/// Call it after all menus.
void end_menu_keys(MenuKeys& keys);

/// Returns whether the first letters of the titles are underlined: while the menu bar has the keyboard or Alt is down.
[[nodiscard]] bool underlines_letters(const MenuKeys& keys);

}  // namespace taxel::ui
