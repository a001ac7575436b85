// Selecting all taxels in an area of the view: a box or a lasso that the hand draws.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// Whether a point lies in the polygon, by the even-odd rule: what a path goes round twice is outside. Fewer than three
/// corners hold nothing.
[[nodiscard]] bool in_polygon(const std::vector<dvec2>& corners, const dvec2& point);

/// While a box or a lasso is drawn: follows the pointer, at `at` [pixels of the view]. True where it has ended, and the
/// taxels within are selected: alone, added with Shift, taken out with Ctrl. Hidden ones stay out, and so do those on
/// the far side of a skin that is not transparent.
bool draw_area(Viewer& viewer, const Shown& shown, ToolState& tool, const dvec2& at, bool hovered);

}  // namespace taxel::ui
