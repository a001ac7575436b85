// Bars of pressure, one per taxel, with peak markers.
#pragma once

#include <imgui.h>

#include <vector>

#include "ui/ui_state.h"

namespace taxel::ui {

struct BarValue {
  int id = 0;        ///< of the taxel
  double value = 0;  ///< [Pa]
  double peak = 0;   ///< largest since the start [Pa]
};

/// Draws bars into `size` at the cursor; heights from 0 to a round number above the largest peak, colours from the
/// shared range. Returns the bar that was clicked, or -1; leaves in ui.bars what was drawn.
int draw_pressure_bars(UiState& ui, const std::vector<BarValue>& values, ImVec2 size, int selected);

}  // namespace taxel::ui
