// Readings over travel, as Figure 4 of the paper: divided by the largest reading of the run, or in kPa.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_plot_panel(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
