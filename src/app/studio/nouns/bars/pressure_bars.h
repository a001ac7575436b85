// Bars of readings, one per taxel, with peak markers.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "ui/scene/scene_input.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

/// The columns of the bars of one sensor [pixels].
struct BarSpan {
  float x0 = 0, x1 = 0;  ///< left and right end of the group
  float step = 0;        ///< width of the column of one bar
  [[nodiscard]] float column(std::size_t bar) const { return x0 + static_cast<float>(bar) * step; }
};

/// Divides the room from x0 to x1 into groups of `counts` columns of equal width, with a gap of at most `gap` between
/// two groups, and twice that gap between groups of different `chains`. Gaps take at most a third of the room. `chains`
/// is parallel to `counts`, or empty if all groups are of one chain.
[[nodiscard]] std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, std::span<const int> chains,
                                                float x0, float x1, float gap);

/// Returns the least number n so that every nth text of a row of columns fits: 1, 2, 5, 10, 20 and so on. `widest` is
/// the width of the widest text with its gap, `step` the width of a column.
[[nodiscard]] std::size_t text_stride(float widest, float step);

/// The reading of one taxel.
struct BarValue {
  int id = 0;                  ///< id of the taxel
  double value = 0;            ///< reading, in SI units
  double peak = 0;             ///< largest reading since the start, in SI units
  int color = 0;               ///< colour number of the taxel
  double error = 0;            ///< error bar of the reading, in SI units; 0 to draw none
  std::string_view name = {};  ///< name of the taxel; may be empty
};

/// The readings of one sensor.
struct BarGroup {
  int sensor = 0;  ///< index of the sensor in the simulation
  std::string name;
  ReadingUnit unit;
  double top = 1;  ///< upper end of the axis, in SI units
  std::vector<BarValue> values;
  SensorPlace place;    ///< place of the sensor among the bodies
  PressureRange range;  ///< range of the colours of the readings
};

/// Returns the bars of all sensors with taxels of the displayed step, from body to body; or if `probed` those of the
/// probe in LAYOUT, which must be pressed.
[[nodiscard]] std::vector<BarGroup> bar_groups(const Viewer& viewer, const Shown& shown, bool probed);

/// A taxel that was clicked.
struct ClickedBar {
  int sensor = 0, id = 0;
};

/// Returns the group of the selected sensor, or the first group. Needs a group.
[[nodiscard]] const BarGroup& selected_group(const std::vector<BarGroup>& groups, const Selection& selection);

/// Returns the tooltip of a taxel: its name with that of its sensor if there are several, reading, error bar and peak.
[[nodiscard]] std::string bar_tip(const std::vector<BarGroup>& groups, const BarGroup& group, const BarValue& bar);

/// Returns whether the bars of all groups are wide enough in a room of `width` pixels to be distinguished.
[[nodiscard]] bool fits_as_bars(const std::vector<BarGroup>& groups, float width, float pixel_scale);

/// Draws the bars into an area of `size` at the cursor, group by group, with the names of the sensors below if there
/// are several. A bar has the colour of its taxel, with an outline if the colour is hard to see on the background; its
/// height is the reading, and a whisker its error bar. A bar above a fixed range ends in an arrow. The numbers of the
/// axis are those of the selected sensor; a group with another unit has the upper end of its axis behind its name. Bars
/// of selected taxels are highlighted. No text overlaps another one: if ids do not fit below all bars, every second,
/// fifth or tenth bar has its id. If values do not fit below all bars, those of selected taxels and of those with the
/// largest peaks are directly above their bars. The axis names its unit if `with_unit`. Records the drawn bars in
/// `shown`. Returns the clicked bar, if any.
std::optional<ClickedBar> draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& shown,
                                             const std::vector<BarGroup>& groups, ImVec2 size, bool with_unit);

}  // namespace taxel::ui
