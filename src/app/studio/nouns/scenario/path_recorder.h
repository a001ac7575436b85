// Recording of a path's waypoints from the motion of the tool, which a scenario or the user moves.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scenario/path_state.h"

namespace taxel::ui {

/// Returns whether there is a tool whose path the document could have.
[[nodiscard]] bool can_record_path(const Viewer& viewer, const Shown& shown);

/// Begins a recording, or ends the running one. The recorded waypoints become the document's path, as one edit.
void toggle_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages);

/// Deselects and releases the waypoint after another scene has begun. A recording continues with the new run.
void let_go_of_way_points(PathState& path_state);

/// Records the path of the ball that the user moves.
extern const Feature kPathRecorder;
/// Sets "scenario": the edited and the running one, and the waypoints.
void dump_scenario(const App& app, nlohmann::ordered_json& state);

struct ToggleRecordPath {};
void carry_out(const ToggleRecordPath& command, App& app);

}  // namespace taxel::ui
