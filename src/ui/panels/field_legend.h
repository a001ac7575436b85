// Legends of the overlays about receptive fields: what their colours mean, with numbers.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {

/// In the lower right corner of the view, one above the other, the lowest ending at `bottom` [pixel of the window].
void draw_field_legends(const UiState& ui, const FieldNumbers& numbers, const SensorModel& model, float bottom);

}  // namespace taxel::ui
