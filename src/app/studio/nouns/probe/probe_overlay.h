// Drawings of the probe tool over the 3-D view.
#pragma once

#include <imgui.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_state.h"

namespace taxel::ui {

/// Draws the handle at which a placed probe can be grabbed.
void draw_probe_handle(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ProbeState& probe,
                       ImDrawList& list);
/// Returns the text about the mouse while the probe is held. Empty otherwise.
[[nodiscard]] const char* probe_hint(const ProbeState& probe);

}  // namespace taxel::ui
