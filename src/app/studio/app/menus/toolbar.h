// Below the menus: mode, transport, speed, what is drawn.
#pragma once

#include "app/studio/app/app.h"

namespace taxel::ui {
void draw_toolbar(App& app);
}  // namespace taxel::ui
