// The curves of both layouts in one plot: A as lines, B as dashes.
#pragma once

#include <imgui.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/compare/compare_state.h"

namespace taxel::ui {

/// Draws plot and legend into an area of `size` at the cursor. A click into the plot displays that step; a click on an
/// entry of A selects its taxel. Fills the curves of `compare.shown`.
void draw_compare_plot(WindowUi& ui, Viewer& viewer, const RunView& run, const ComparedLayouts& compared,
                       CompareState& compare, ImVec2 size);

}  // namespace taxel::ui
