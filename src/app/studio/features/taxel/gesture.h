// Gestures on taxels: how they begin, follow pointer and keys, and end. Each is one step of the history.
#pragma once

#include "app/studio/app/ui_state.h"
#include "app/studio/features/taxel/gesture_edit.h"

namespace taxel::ui {

/// How the layout is seen.
[[nodiscard]] GestureView gesture_view(const UiState& ui, const UiInput& input);

/// With the selected way point, or the selected taxels; `copies`: with copies of them, which the gesture adds. Nothing
/// where none is selected.
void begin_gesture(UiState& ui, const UiInput& input, Tool tool, bool copies = false);
void accept_gesture(UiState& ui, const UiInput& input);
/// Of any tool: all is as it was.
void cancel_tool(UiState& ui);

/// What was typed in this frame goes into the running gesture's number.
void type_number(UiState& ui);
void constrain_gesture(UiState& ui, int axis);  ///< once more: free again

/// Requests the edit that pointer and keys make of the gesture, if they have changed.
void follow_gesture(UiState& ui, const UiInput& input);
/// Ends any tool without an edit.
void end_tool(UiState& ui);

/// A taxel on the surface under a pixel of the view; none on the background.
void place_taxel(UiState& ui, const UiInput& input, double x, double y);
/// Ctrl+wheel: 2 % a notch, a row of notches is one step.
void resize_by_wheel(UiState& ui, const UiInput& input, double notches);

/// The taxel that a click would add.
struct PlacementGhost {
  Taxel taxel;
  int samples = 0;  ///< of the shown model, in its field
};
[[nodiscard]] std::optional<PlacementGhost> placement_ghost(const UiState& ui, const UiInput& input, double x,
                                                            double y);

}  // namespace taxel::ui
