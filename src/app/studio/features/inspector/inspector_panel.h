// Values of the selected taxel, the sampling, the material, the scene and the sweep.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/inspector/material_state.h"
#include "app/studio/features/inspector/model_summary.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/scenario/path_state.h"

namespace taxel::ui {
void draw_inspector(WindowUi& ui, Viewer& viewer, const Shown& shown, const LayoutProblems& problems, MeshState& mesh,
                    MaterialState& material, const ModelSummary& summary, FollowState& follow, PathState& path,
                    PanelsShown& panels, Messages& messages);
}  // namespace taxel::ui
