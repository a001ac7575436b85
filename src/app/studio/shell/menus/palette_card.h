// The command palette (Ctrl+K): type part of a name, choose with the arrows, run with Enter.
#pragma once

namespace taxel::ui {

struct App;

void draw_palette(App& app);
}  // namespace taxel::ui
