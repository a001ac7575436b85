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
  int id = 0;        ///< id of the taxel
  double value = 0;  ///< reading, in SI units
  double peak = 0;   ///< largest reading since the start, in SI units
  int color = 0;     ///< colour number of the taxel
};

/// Returns the upper end of the bars' axis: a round number above the largest value and peak [unit of the readings].
[[nodiscard]] double bars_top(const std::vector<BarValue>& values, const ReadingUnit& unit);

/// Draws the bars into an area of `size` at the cursor. The axis reaches from 0 to a round number above the largest
/// peak. Colours follow the shared pressure range, or the range of the bars if the readings are not pressures. Bars of
/// selected taxels are highlighted. Records the drawn bars in `bars`. Returns the index of the clicked bar, or -1.
int draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& bars, const std::vector<BarValue>& values,
                       const ReadingUnit& unit, ImVec2 size);

}  // namespace taxel::ui
