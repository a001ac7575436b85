// The legend of the colours: one colour bar for the pressures of the contact surface, one for the readings.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/scene/scene_input.h"
#include "ui/widgets/format.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Place of the legend.
struct LegendPlace {
  ImVec2 corner;  ///< upper right corner
  float width = 0, height = 0;
};

/// The ranges that the legend displays, each as a colour bar with ticks, unit, and a button of the
/// range.
struct LegendScales {
  PressureRange surface;    ///< range of the contact surface's pressures
  PressureRange readings;   ///< range of the readings, apart from that of the surface
  ReadingUnit unit;         ///< unit of the readings
  bool linked = false;      ///< whether both have one range; then one colour bar is drawn
  bool has_buttons = true;  ///< whether the legend has its buttons
};

/// The buttons of the legend that were clicked.
struct LegendClicks {
  bool surface = false, readings = false, link = false;
};

/// Returns the size of the legend that fits in a room.
[[nodiscard]] ImVec2 legend_size(const LegendScales& scales, ImVec2 room);

/// Places the buttons: whether each range follows the run, and whether there is one for both. Must be called before the
/// items that the legend covers are drawn, so that the buttons get the clicks.
LegendClicks place_legend_buttons(Ui& ui, const LegendScales& scales, const LegendPlace& place);
/// Returns the numbers along a colour bar, the lowest first: `ticks` + 1 numbers, evenly from range.lo to range.hi, in
/// the displayed unit.
[[nodiscard]] std::vector<std::string> legend_texts(const PressureRange& range, int ticks,
                                                    const ReadingUnit& unit = ReadingUnit{});
/// Draws the legend. Records its numbers as widgets of the panels "Pressure legend" and "Readings legend", and its
/// other texts as widgets of the panel "Legend", so that scripts can read them.
void draw_pressure_legend(Ui& ui, const LegendScales& scales, const LegendPlace& place);

/// Draws a scale of colours at the cursor, in a row of height `row` [pixels], if the rest of the row has room for it:
/// the lower end, the colours, and the upper end with its unit.
void draw_color_scale(const Ui& ui, const PressureRange& range, const ReadingUnit& unit, float row);

/// Returns the colour of a number in a range.
ImU32 pressure_color(const PressureRange& range, double pressure, float alpha = 1.0f);
/// Returns the colour of a taxel by its number, SensorModel::color.
ImU32 taxel_color_u32(int number, float alpha = 1.0f);

}  // namespace taxel::ui
