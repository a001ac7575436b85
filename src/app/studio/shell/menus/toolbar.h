// Toolbar below the menus: mode, transport, speed, displayed overlays.
#pragma once

namespace taxel::ui {

struct App;

void draw_toolbar(App& app);
}  // namespace taxel::ui
