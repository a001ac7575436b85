// The menus, made from the table of bindings.
#pragma once

namespace taxel::ui {

struct App;

void draw_menu_bar(App& app);
}  // namespace taxel::ui
