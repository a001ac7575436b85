// The scene of the 3-D view, its extent, and the pose of the edited sensor in it.
#pragma once

#include "app/studio/frame/shown.h"
#include "core/base/math.h"

namespace taxel::ui {

struct App;

/// Returns the box that the camera can frame: sensor and path in SIMULATE, mesh in LAYOUT. Empty if there is nothing.
[[nodiscard]] Aabb scene_box(const Viewer& viewer, const Shown& shown);
/// Returns the box of the selected taxels' receptive fields. If none is selected, returns the box of the selected
/// sensor in SIMULATE, and an empty box in LAYOUT.
[[nodiscard]] Aabb selection_box(const Viewer& viewer, const Shown& shown);
/// Returns the pose of the mesh file's frame in the world, as the view shows it.
[[nodiscard]] Pose shown_pose(const Viewer& viewer, const Shown& shown);

/// Returns the scene that the 3-D view and the section draw.
[[nodiscard]] SceneInput scene_input(const App& app);

/// Adds a clip plane through the middle, across the line of sight, or removes it.
void toggle_clip(Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
