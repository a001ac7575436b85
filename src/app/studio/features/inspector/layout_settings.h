// The settings of the layout that is edited, as fields of the inspector: each change is one undoable edit.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/inspector/model_summary.h"

namespace taxel::ui {

/// Name, frame, sampling, receptive fields, readout, material.
void draw_layout_settings(WindowUi& ui, const DocumentView& document, const ModelSummary& summary);
/// How a device would report the readings; a switch makes or removes it.
void draw_calibration_settings(WindowUi& ui, const Layout& layout);

}  // namespace taxel::ui
