// The bars of commands, made from the table of bindings: menus, toolbar, strip of tools, and the palette, which finds
// commands by parts of their names.
#pragma once

#include <string_view>
#include <vector>

#include "app/studio/frame/keymap.h"

namespace taxel::ui {

struct App;

void draw_menu_bar(App& app);
/// Returns the title of the open menu of the bar; empty if none is open.
[[nodiscard]] const char* open_menu(const App& app);

/// Draws the bar below the menus: mode, transport, speed, displayed overlays.
void draw_toolbar(App& app);

/// Draws the strip at the left edge of the view, one button for each tool of the mode. Sets the width that the view's
/// texts leave free for the strip.
void draw_tool_strip(App& app);

/// Returns the commands of the keymap that match `typed`, best first. A command matches if its name, its menu, its
/// chord and its synonyms contain every word of `typed` ("export lay", "view cov", "ctrl+e", "gif"). If no command
/// matches in this way, a command matches if its name contains the letters of `typed` in order ("prjbk"). Case is
/// ignored. Names that begin with `typed` come first, then names with a word that begins with `typed`, then the others;
/// equal matches keep the order of the keymap. An empty text matches all commands. Keys of gestures and fields are not
/// commands.
std::vector<const Binding*> find_commands(std::string_view typed, const KeyNames& names = {});

/// Draws the command palette (Ctrl+K): type part of a name, choose with the arrows, run with Enter.
void draw_palette(App& app);

}  // namespace taxel::ui
