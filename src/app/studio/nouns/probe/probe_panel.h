// A small window over the 3-D view with the settings and the readings of the probe.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_state.h"

namespace taxel::ui {

void draw_probe_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, ProbeState& probe);

}  // namespace taxel::ui
