// The mesh of the edited document in the inspector: unit, size, direction of the sensor, and defects of the mesh.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"

namespace taxel::ui {
/// Draws the inspector's section about the mesh.
void draw_mesh_section(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       PanelsShown& panels, const SensorModel& model);

/// Every defect of the mesh, in a window of its own.
extern const Feature kMeshReport;
/// Sets "frame_guess", and "show_changes" of the mesh of the document.
void dump_mesh(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
