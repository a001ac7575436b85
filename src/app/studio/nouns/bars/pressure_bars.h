// Bars of readings, one per taxel, with peak markers.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

/// The columns of the bars of one sensor [pixels].
struct BarSpan {
  float x0 = 0, x1 = 0;  ///< left and right end of the group
  float step = 0;        ///< width of the column of one bar
  [[nodiscard]] float column(std::size_t bar) const { return x0 + static_cast<float>(bar) * step; }
};

/// Divides the room from x0 to x1 into groups of `counts` columns of equal width, with a gap of at most `gap` between
/// two groups. Gaps take at most a third of the room.
[[nodiscard]] std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, float x0, float x1, float gap);

struct BarValue {
  int id = 0;        ///< id of the taxel
  double value = 0;  ///< reading, in SI units
  double peak = 0;   ///< largest reading since the start, in SI units
  int color = 0;     ///< colour number of the taxel
  double error = 0;  ///< error bar of the reading, in SI units; 0 to draw none
};

/// The bars of one sensor.
struct BarGroup {
  int sensor = 0;  ///< index of the sensor in the simulation
  std::string name;
  ReadingUnit unit;
  double top = 1;  ///< upper end of the axis, in SI units
  std::vector<BarValue> values;
};

/// A bar that was clicked.
struct ClickedBar {
  int sensor = 0, id = 0;
};

/// Draws the bars into an area of `size` at the cursor, group by group, with the names of the sensors below if there
/// are several. A bar has the colour of its taxel, with an outline if the colour is hard to see on the background; its
/// height is the reading, and a whisker its error bar. A bar above a fixed range ends in an arrow. The numbers of the
/// axis are those of the selected sensor; a group with another unit has the upper end of its axis behind its name. Bars
/// of selected taxels are highlighted. The axis names its unit if `with_unit`. Records the drawn bars in `bars`.
/// Returns the clicked bar, if any.
std::optional<ClickedBar> draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& bars,
                                             const std::vector<BarGroup>& groups, ImVec2 size, bool with_unit);

}  // namespace taxel::ui
