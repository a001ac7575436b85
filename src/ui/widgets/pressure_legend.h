// The colour bar of pressure: one map and one range for everything that is coloured by pressure.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/scene/scene_input.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// The legend's place: upper right corner and height. The legend shows the colour map, ticks in kPa, AUTO or LOCKED.
struct LegendPlace {
  ImVec2 corner;
  float height = 0;
};

float pressure_legend_width();

/// The button that switches AUTO and LOCKED; to be placed before what the legend covers, so that it gets the click.
void place_range_button(Ui& ui, PressureRange& range, const LegendPlace& place);
/// Numbers along the colour bar in kPa, the lowest first: `ticks` + 1 of them, evenly from range.lo to range.hi.
[[nodiscard]] std::vector<std::string> legend_texts(const PressureRange& range, int ticks);
/// Notes the numbers as widgets of the panel "Pressure legend", so that scripts know what was drawn and where.
void draw_pressure_legend(Ui& ui, const PressureRange& range, const LegendPlace& place);

/// Colour of a pressure in the shared range.
ImU32 pressure_color(const PressureRange& range, double pressure, float alpha = 1.0f);
/// A taxel's own colour, by SensorModel::color.
ImU32 taxel_color_u32(int number, float alpha = 1.0f);

}  // namespace taxel::ui
