// The mesh of what is edited: its unit, its size, where the sensor points; and what was found wrong with it.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// A part of the inspector.
void draw_mesh_section(UiState& ui, const UiInput& input, const SensorModel& model);
/// A window of its own: every finding, and what it means for sensing.
void draw_mesh_report(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
