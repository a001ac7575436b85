// The way points of a path as numbers.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Time and place of each, how the selected one is turned, and buttons that add and delete.
void draw_way_point_table(UiState& ui, const UiInput& input, const Scenario& scenario);

}  // namespace taxel::ui
