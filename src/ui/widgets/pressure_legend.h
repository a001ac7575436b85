// The colour bar of pressure: one map and one range for everything that is coloured by pressure.
#pragma once

#include <imgui.h>

#include "ui/ui_state.h"

namespace taxel::ui {

/// Draws the legend with its upper right corner at `corner`: viridis, ticks in kPa, AUTO or LOCKED (a click switches).
void draw_pressure_legend(UiState& ui, ImVec2 corner, float height);

/// Colour of a pressure in the shared range.
ImU32 pressure_color(const PressureRange& range, double pressure, float alpha = 1.0f);
/// A taxel's own colour.
ImU32 taxel_color_u32(int index, float alpha = 1.0f);

}  // namespace taxel::ui
