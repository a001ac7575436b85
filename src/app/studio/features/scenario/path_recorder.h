// Way points of a path from the tool's motion: by a scenario, or by hand.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/scenario/path_state.h"

namespace taxel::ui {

/// Whether there is a tool whose path the document could have.
[[nodiscard]] bool can_record_path(const Viewer& viewer, const Shown& shown);

/// Begins; or ends, and what was kept becomes the document's path, as one edit.
void toggle_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages);

/// Once a picture: keeps the tool's pose where it is due, and ends where the run does. A pose is timed by the
/// simulation while it goes on, and by the clock of the hand that moves the tool while it stands. Steps of the past are
/// left out.
void follow_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, const PerturbState& perturb,
                           PathState& path, Messages& messages);

/// Another scene runs: nothing is in the hand any more. A recording goes on with the run that begins.
void let_go_of_way_points(PathState& path_state);

}  // namespace taxel::ui
