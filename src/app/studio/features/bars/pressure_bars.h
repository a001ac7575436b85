// Bars of readings, one per taxel, with peak markers.
#pragma once

#include <imgui.h>

#include <vector>

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/bars/bars_state.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

struct BarValue {
  int id = 0;        ///< of the taxel
  double value = 0;  ///< reading, in SI
  double peak = 0;   ///< largest since the start
  int color = 0;     ///< of the taxel
};

/// The upper end of the bars' axis: a round number above the largest value and peak [unit of the readings].
[[nodiscard]] double bars_top(const std::vector<BarValue>& values, const ReadingUnit& unit);

/// Draws bars into `size` at the cursor; heights from 0 to a round number above the largest peak, colours from the
/// shared range, or from the bars' own where readings are no pressures. Those of selected taxels stand out. Returns the
/// bar that was clicked, or -1; leaves in app.simulate.bars what was drawn.
int draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& bars, const std::vector<BarValue>& values,
                       const ReadingUnit& unit, ImVec2 size);

}  // namespace taxel::ui
