// Editing of a scenario's waypoints in the 3-D view.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scenario/path_state.h"
#include "app/studio/nouns/taxel/gesture_edit.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// Returns the edited scenario of the document if the running scene was built from the document; null otherwise.
[[nodiscard]] const Scenario* edited_scenario(const Viewer& viewer, const Shown& shown);

/// Returns the edited path of the document, or nothing if the scenario is of another kind.
[[nodiscard]] std::optional<ShownPath> edited_path(const Viewer& viewer, const Shown& shown,
                                                   const PathState& path_state);

/// Returns the initial waypoints of a new path, which approximate the running scenario.
[[nodiscard]] std::vector<WayPoint> points_to_begin_with(const Viewer& viewer, const Shown& shown);

/// Adds a waypoint at the present pose of the finger, after the selected waypoint, or at the end if none is selected.
void add_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// Deletes the selected waypoint. A path retains at least two waypoints.
void delete_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path);
/// Returns whether a waypoint that can be moved is selected.
[[nodiscard]] bool has_way_point(const Viewer& viewer, const Shown& shown, const PathState& path);
/// Begins a gesture at the selected waypoint. Returns false if no waypoint is selected.
bool take_way_point(const Viewer& viewer, const Shown& shown, PathState& path);
/// Returns the edit that moves the waypoint by the gesture: with the pointer in the plane that faces the camera, along
/// an axis of the world, or by a typed number.
[[nodiscard]] GestureEdit moved_way_point(const Viewer& viewer, const Shown& shown, const ToolState& tool,
                                          const PathState& path);
/// Cancels the drag of the selected waypoint, which returns to its former place.
void cancel_way_point_drag(WindowUi& ui, PathState& path);

/// Handles the mouse. A click on a glyph selects the waypoint, and a drag moves the waypoint in the plane that faces
/// the camera. Returns whether the mouse was consumed.
bool handle_path_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, PathState& state,
                       const PointerEvent& event);

/// The waypoints of a path in the view.
extern const Feature kPath;

}  // namespace taxel::ui
