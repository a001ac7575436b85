// The menus, made from the table of bindings.
#pragma once

namespace taxel::ui {

struct App;

void draw_menu_bar(App& app);
/// Returns the title of the open menu of the bar; empty if none is open.
[[nodiscard]] const char* open_menu(const App& app);
}  // namespace taxel::ui
