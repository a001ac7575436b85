// The mesh of what is edited: its unit, its size, where the sensor points; and what was found wrong with it.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/mesh/mesh_state.h"

namespace taxel::ui {
/// A part of the inspector.
void draw_mesh_section(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       PanelsShown& panels, const SensorModel& model);
/// A window of its own: every finding, and what it means for sensing.
void draw_mesh_report(WindowUi& ui, const ViewPlace& place, const DocumentView& document, PanelsShown& panels);
}  // namespace taxel::ui
