// The settings of the layout that is edited, as fields of the inspector: each change is one undoable edit.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Name, frame, sampling, receptive fields, readout, material.
void draw_layout_settings(UiState& ui, const UiInput& input);
/// How a device would report the readings; a switch makes or removes it.
void draw_calibration_settings(UiState& ui, const Layout& layout);

}  // namespace taxel::ui
