// Recording of a path's waypoints from the motion of the tool, which a scenario or the user moves.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/scenario/path_state.h"

namespace taxel::ui {

/// Returns whether there is a tool whose path the document could have.
[[nodiscard]] bool can_record_path(const Viewer& viewer, const Shown& shown);

/// Begins a recording, or ends the running one. The recorded waypoints become the document's path, as one edit.
void toggle_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages);

/// Records the tool's pose when the next waypoint is pending, and ends the recording together with the run. Is called
/// once per frame. The time of a pose is simulated time while the simulation runs, and real time while the user moves
/// the tool in a paused simulation. Recorded steps that are displayed again are left out.
void follow_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, const PerturbState& perturb,
                           PathState& path, Messages& messages);

/// Deselects and releases the waypoint after another scene has begun. A recording continues with the new run.
void let_go_of_way_points(PathState& path_state);

}  // namespace taxel::ui
