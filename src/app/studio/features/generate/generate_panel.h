// The panel that generates many taxels at once: a pattern, its parameters, and a live preview in the view.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/menus/tour_state.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {
void draw_generate_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, const ToolState& tool,
                         GenerateState& generate, const TourState& tour, FileDialog& dialog);
/// Draws the frame of the pattern in the view: the centre, the direction of the rows and the direction across them.
void draw_pattern_frame(const Viewer& viewer, const Shown& shown, const GenerateState& generate);
}  // namespace taxel::ui
