// Gestures on taxels: their start, their updates from pointer and keys, and their end. Each gesture is one step of the
// history.
#pragma once

#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scenario/path_state.h"
#include "app/studio/nouns/taxel/gesture_edit.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// Returns the view of the layout for gestures.
[[nodiscard]] GestureView gesture_view(const Viewer& viewer, const Shown& shown);

/// Begins a gesture with the selected waypoint or the selected taxels. If `copies`, the gesture adds and changes copies
/// of the taxels. Does nothing if nothing is selected.
void begin_gesture(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool_state, PathState& path, Tool tool,
                   bool copies = false);
void accept_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Cancels any tool and restores the state before the tool.
void cancel_tool(WindowUi& ui, Selection& selection, ToolState& tool);

/// Adds the characters typed in this frame to the number of the running gesture.
void type_number(ToolState& tool);
void constrain_gesture(ToolState& tool, int axis);  ///< constrains to an axis; a second call frees again

/// Requests the edit that pointer and keys make of the gesture, if they have changed.
void follow_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Ends any tool without an edit.
void end_tool(ToolState& tool);

/// Adds a taxel on the surface under a pixel of the view. Does nothing on the background.
void place_taxel(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y);
/// Changes the radii of the selected taxels by 2 % per notch of Ctrl+wheel. A series of notches is one step of the
/// history.
void resize_by_wheel(WindowUi& ui, const Selection& selection, const DocumentView& document, ToolState& tool,
                     double notches);

/// The taxel that a click would add.
struct PlacementGhost {
  Taxel taxel;
  int samples = 0;  ///< number of samples of the displayed model in its receptive field
};
[[nodiscard]] std::optional<PlacementGhost> placement_ghost(const Viewer& viewer, const Shown& displayed,
                                                            const ToolState& tool, double x, double y);

}  // namespace taxel::ui
