// Fields of the inspector that turn a data sheet into the modulus of the layout's pad.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/inspector/material_state.h"
#include "core/layout/layout.h"

namespace taxel::ui {

/// Draws a switch, and below it the fields of the data sheet with the resulting modulus. The button Apply sets modulus,
/// thickness and field of the layout's material by one edit.
void draw_material_sheet(WindowUi& ui, const Layout& layout, MaterialState& state);

}  // namespace taxel::ui
