// Editing the way points of a scenario in the 3-D view.
#pragma once

#include "app/studio/app/pointing/pointer_event.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/taxel/gesture_edit.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// The document's scenario where the running scene is built of it, as it is edited; null: there is none.
[[nodiscard]] const Scenario* edited_scenario(const Viewer& viewer, const Shown& shown);

/// The document's path as it is edited, or nothing where its scenario is of another kind.
[[nodiscard]] std::optional<ShownPath> edited_path(const Viewer& viewer, const Shown& shown,
                                                   const PathState& path_state);

/// Way points that do much the same as the scenario that runs: what a path begins with.
[[nodiscard]] std::vector<WayPoint> points_to_begin_with(const Viewer& viewer, const Shown& shown);

/// Adds one where the finger is now: behind the selected one, else at the end.
void add_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// The selected one. A path keeps two.
void delete_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// Whether one is selected that can be moved.
[[nodiscard]] bool has_way_point(const Viewer& viewer, const Shown& shown, const PathState& path);
/// It is where the gesture begins; false: there is none.
bool take_way_point(const Viewer& viewer, const Shown& shown, PathState& path);
/// As the gesture has moved it: with the pointer in the plane that faces the camera, along an axis of the world, or by
/// a number.
[[nodiscard]] GestureEdit moved_way_point(const Viewer& viewer, const Shown& shown, const ToolState& tool,
                                          const PathState& path);
/// Of the selected one, while it is dragged: it is where it was.
void cancel_way_point_drag(WindowUi& ui, PathState& path);

/// A click on a mark selects it, a drag moves it in the plane that faces the camera. True: the mouse is taken.
bool handle_path_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, PathState& state,
                       const PointerEvent& event);

}  // namespace taxel::ui
