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

/// The scale of the bars: the range of the readings, and their unit.
struct BarsScale {
  PressureRange range;  ///< the axis reaches from 0 to `range.hi`, in SI units
  ReadingUnit unit;
};

/// Draws the bars into an area of `size` at the cursor. A bar has the colour of its taxel, with an outline if the
/// colour is hard to see on the background; its height is the reading. A bar above a fixed range ends in an arrow. Bars
/// of selected taxels are highlighted. Records the drawn bars in `bars`. Returns the index of the clicked bar, or -1.
int draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& bars, const std::vector<BarValue>& values,
                       const BarsScale& scale, ImVec2 size);

}  // namespace taxel::ui
