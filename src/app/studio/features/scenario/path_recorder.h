// Way points of a path from the tool's motion: by a scenario, or by hand.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Whether there is a tool whose path the document could have.
[[nodiscard]] bool can_record_path(const UiState& ui, const UiInput& input);

/// Begins; or ends, and what was kept becomes the document's path, as one edit.
void toggle_path_recording(UiState& ui, const UiInput& input);

/// Once a picture: keeps the tool's pose where it is due, and ends where the run does. A pose is timed by the
/// simulation while it goes on, and by the clock of the hand that moves the tool while it stands. Steps of the past are
/// left out.
void follow_path_recording(UiState& ui, const UiInput& input);

/// Another scene runs: nothing is in the hand any more. A recording goes on with the run that begins.
void let_go_of_way_points(UiState& ui);
/// Drops the recording and the values of former kinds, because another document is open.
void leave_path(UiState& ui);

}  // namespace taxel::ui
