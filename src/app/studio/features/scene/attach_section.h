// The sensors of an open scene: those it declares, and layouts attached to its geoms.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// A part of the panel of controls.
void draw_attach_section(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
