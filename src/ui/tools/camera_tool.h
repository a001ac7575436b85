// The hand in the 3-D view: turns mouse gestures into camera moves and selections.
#pragma once

#include "core/base/math.h"
#include "ui/ui_state.h"

namespace taxel::ui {

/// What the camera can frame: the sensor and its path in SIMULATE, the mesh in LAYOUT. Empty: nothing there.
[[nodiscard]] Aabb scene_box(const UiState& ui, const UiInput& input);
/// The selected taxel's receptive field, or empty.
[[nodiscard]] Aabb selection_box(const UiState& ui, const UiInput& input);
/// Frame of the mesh file in the world, as the view shows it now.
[[nodiscard]] Pose shown_pose(const UiState& ui, const UiInput& input);

/// Layout index of the front-facing taxel nearest to a pixel of the view, within reach; -1: none.
[[nodiscard]] int taxel_at(const UiState& ui, const UiInput& input, double x, double y);
/// First point of what is drawn along the ray through a pixel of the view: sensor skins and geoms.
[[nodiscard]] std::optional<dvec3> point_at(const UiState& ui, const UiInput& input, double x, double y);

/// Reads ImGui's mouse over the view's item (the last one): orbit, pan, zoom, centre, select, hover.
void handle_view_mouse(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
