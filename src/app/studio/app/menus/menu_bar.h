// The menus, made from the table of bindings.
#pragma once

#include "app/studio/app/app.h"

namespace taxel::ui {
void draw_menu_bar(App& app);
}  // namespace taxel::ui
