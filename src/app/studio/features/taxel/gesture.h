// Gestures on taxels: how they begin, follow pointer and keys, and end. Each is one step of the history.
#pragma once

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/taxel/gesture_edit.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// How the layout is seen.
[[nodiscard]] GestureView gesture_view(const Viewer& viewer, const Shown& shown);

/// With the selected way point, or the selected taxels; `copies`: with copies of them, which the gesture adds. Nothing
/// where none is selected.
void begin_gesture(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool_state, PathState& path, Tool tool,
                   bool copies = false);
void accept_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Of any tool: all is as it was.
void cancel_tool(WindowUi& ui, Selection& selection, ToolState& tool);

/// What was typed in this frame goes into the running gesture's number.
void type_number(ToolState& tool);
void constrain_gesture(ToolState& tool, int axis);  ///< once more: free again

/// Requests the edit that pointer and keys make of the gesture, if they have changed.
void follow_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path);
/// Ends any tool without an edit.
void end_tool(ToolState& tool);

/// A taxel on the surface under a pixel of the view; none on the background.
void place_taxel(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y);
/// Ctrl+wheel: 2 % a notch, a row of notches is one step.
void resize_by_wheel(WindowUi& ui, const Selection& selection, const DocumentView& document, ToolState& tool,
                     double notches);

/// The taxel that a click would add.
struct PlacementGhost {
  Taxel taxel;
  int samples = 0;  ///< of the shown model, in its field
};
[[nodiscard]] std::optional<PlacementGhost> placement_ghost(const Viewer& viewer, const Shown& displayed,
                                                            const ToolState& tool, double x, double y);

}  // namespace taxel::ui
