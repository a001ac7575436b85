// The bars of commands, made from the table of bindings: menus, toolbar, strip of tools, and the palette, which finds
// commands, fields, gestures and headings of the guide.
#pragma once

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

/// Draws the command palette (Ctrl+K): type some words, choose with the arrows, run or show with Enter.
void draw_palette(App& app);

}  // namespace taxel::ui
