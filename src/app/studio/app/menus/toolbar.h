// Below the menus: mode, transport, speed, what is drawn.
#pragma once

namespace taxel::ui {

struct App;

void draw_toolbar(App& app);
}  // namespace taxel::ui
