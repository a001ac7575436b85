// The settings of the edited layout, as fields of the inspector. Each change is one undoable edit.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/inspector/material_state.h"
#include "app/studio/nouns/inspector/model_summary.h"

namespace taxel::ui {

/// Draws the fields of name, frame, sampling, receptive fields, readout and material.
void draw_layout_settings(WindowUi& ui, const DocumentView& document, const ModelSummary& summary,
                          MaterialState& material);
/// Draws the fields of the calibration, which models how a device reports the readings. A switch adds or removes the
/// calibration.
void draw_calibration_settings(WindowUi& ui, const Layout& layout);

}  // namespace taxel::ui
