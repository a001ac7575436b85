// The selection: of all taxels in an area of the view, a box or a lasso that the user draws, and by commands.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// Returns whether a point is in the polygon by the even-odd rule: a region that the path surrounds twice is outside.
/// A polygon of fewer than three corners contains no point.
[[nodiscard]] bool in_polygon(const std::vector<dvec2>& corners, const dvec2& point);

/// Moves the box or the lasso that is being drawn to the pointer at `at` [pixels of the view]. Returns true once the
/// area is complete and its taxels are selected: instead of the selection, added to it with Shift, or removed from it
/// with Ctrl. Hidden taxels are never selected, nor are taxels on the far side of an opaque skin.
bool draw_area(Viewer& viewer, const Shown& shown, ToolState& tool, const dvec2& at, bool hovered);

struct SelectAll {};
struct SelectNone {};
struct InvertSelection {};
struct SelectParentBody {};

void carry_out(const SelectAll& command, App& app);
void carry_out(const SelectNone& command, App& app);
void carry_out(const InvertSelection& command, App& app);
void carry_out(const SelectParentBody& command, App& app);

}  // namespace taxel::ui
