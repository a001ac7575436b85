// The parameters of a pattern, as fields with units; of each kind its own.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_pattern_fields(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
