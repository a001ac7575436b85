// Values of the selected taxel, the sampling, the material, the scene and the sweep.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/inspector/layout_problems.h"
#include "app/studio/nouns/inspector/material_state.h"
#include "app/studio/nouns/inspector/model_summary.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/scenario/path_state.h"

namespace taxel::ui {
/// All values of the layout and of the selection.
extern const Feature kInspector;
/// Sets "problems" and "region".
void dump_inspector(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
