// The colour bar of pressure. Everything that is coloured by pressure shares its colour map and its range.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/scene/scene_input.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Place of the legend. The legend displays the colour map, ticks in kPa, and AUTO or LOCKED.
struct LegendPlace {
  ImVec2 corner;  ///< upper right corner
  float height = 0;
};

float pressure_legend_width();

/// Places the button that toggles AUTO and LOCKED. Must be called before the items that the legend covers are drawn, so
/// that the button gets the click.
void place_range_button(Ui& ui, PressureRange& range, const LegendPlace& place);
/// Returns the numbers along the colour bar in kPa, the lowest first: `ticks` + 1 numbers, evenly from range.lo to
/// range.hi.
[[nodiscard]] std::vector<std::string> legend_texts(const PressureRange& range, int ticks);
/// Draws the legend. Records the numbers as widgets of the panel "Pressure legend", so that scripts can read them.
void draw_pressure_legend(Ui& ui, const PressureRange& range, const LegendPlace& place);

/// Returns the colour of a pressure in the shared range.
ImU32 pressure_color(const PressureRange& range, double pressure, float alpha = 1.0f);
/// Returns the colour of a taxel by its number, SensorModel::color.
ImU32 taxel_color_u32(int number, float alpha = 1.0f);

}  // namespace taxel::ui
