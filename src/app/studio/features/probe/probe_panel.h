// A small window over the 3-D view with the settings and the readings of the probe.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/probe/probe_state.h"

namespace taxel::ui {

void draw_probe_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, ProbeState& probe);

}  // namespace taxel::ui
