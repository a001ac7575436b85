// The table of a path's waypoints as numbers.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scenario/path_state.h"

namespace taxel::ui {

/// Draws time and place of each waypoint, the rotation of the selected waypoint, and buttons that add and delete.
void draw_way_point_table(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path,
                          const Scenario& scenario);

}  // namespace taxel::ui
