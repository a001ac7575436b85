// What tools draw over the 3-D view: the taxel that a click would add, the box, what a gesture does, and why not.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
void draw_tool_overlay(const UiState& ui, const UiInput& input);
}  // namespace taxel::ui
