// The mesh of the edited document in the inspector: unit, size, direction of the sensor, and defects of the mesh.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/mesh/mesh_state.h"

namespace taxel::ui {
/// Draws the inspector's section about the mesh.
void draw_mesh_section(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       PanelsShown& panels, const SensorModel& model);
/// Draws a separate window with every defect of the mesh and the defect's consequence for sensing.
void draw_mesh_report(WindowUi& ui, const ViewPlace& place, const DocumentView& document, PanelsShown& panels);
}  // namespace taxel::ui
