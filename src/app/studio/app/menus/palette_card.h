// The command palette (Ctrl+K): type part of a name, choose with the arrows, run with Enter.
#pragma once

#include "app/studio/app/app.h"

namespace taxel::ui {
void draw_palette(App& app);
}  // namespace taxel::ui
