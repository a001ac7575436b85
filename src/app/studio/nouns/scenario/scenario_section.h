// The inspector's section about the scenario, which moves the finger.
#pragma once

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scenario/path_state.h"

namespace taxel::ui {

/// Draws the kind of the scenario, its values, its waypoints, and the button that runs the scenario. Each change is an
/// edit of the document.
void draw_scenario_section(WindowUi& ui, const Viewer& viewer, const Shown& displayed, PathState& path,
                           Messages& messages);

}  // namespace taxel::ui
