// The repair of the document's mesh in the inspector, and the legend of its changes.
#pragma once

#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"

namespace taxel::ui {

/// Returns the state of the mesh, with the distances by which its repair moved the surface: "open", "closed",
/// "wrapped, off by 0.120 mm rms, 0.500 mm at most".
[[nodiscard]] std::string mesh_state_text(const SensorModel& model);

/// Draws the rows of the mesh's properties about repair: the state of the mesh and the level of the repair.
void draw_repair_rows(WindowUi& ui, const DocumentView& document, const SensorModel& model);
/// Draws the buttons below the rows, and a line for each step of the repair.
void draw_repair_steps(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       const SensorModel& model);

}  // namespace taxel::ui
