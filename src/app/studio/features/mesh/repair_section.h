// The repair of the document's mesh in the inspector, and the legend of its changes.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Rows of the properties of the mesh: its state and the level of its repair.
void draw_repair_rows(UiState& ui, const UiInput& input, const SensorModel& model);
/// Below them: buttons, and a line for each step of the repair.
void draw_repair_steps(UiState& ui, const UiInput& input, const SensorModel& model);

}  // namespace taxel::ui
