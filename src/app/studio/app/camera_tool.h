// The hand in the 3-D view: turns mouse gestures into camera moves and selections.
#pragma once

#include "app/studio/app/ui_state.h"
#include "core/base/math.h"

namespace taxel::ui {

/// What the camera can frame: the sensor and its path in SIMULATE, the mesh in LAYOUT. Empty: nothing there.
[[nodiscard]] Aabb scene_box(const UiState& ui, const UiInput& input);
/// The selected taxels' receptive fields, or empty.
[[nodiscard]] Aabb selection_box(const UiState& ui, const UiInput& input);
/// Frame of the mesh file in the world, as the view shows it now.
[[nodiscard]] Pose shown_pose(const UiState& ui, const UiInput& input);

/// What the 3-D view and the section draw now.
[[nodiscard]] SceneInput scene_input(const UiState& ui, const UiInput& input);

/// Cuts the view open through the middle, across the line of sight, or closes it.
void toggle_clip(UiState& ui, const UiInput& input);

/// Reads ImGui's mouse over the view's item (the last one): orbit, pan, zoom, centre, select, hover.
void handle_view_mouse(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
