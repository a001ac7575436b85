// Drawings of the measure tool over the 3-D view.
#pragma once

#include <imgui.h>

#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_state.h"

namespace taxel::ui {

/// Draws the two distances next to the middle of the line.
void draw_measure_label(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const MeasureState& measure,
                        ImDrawList& list);
/// Returns the text about the next click. Empty if the tool is off.
[[nodiscard]] std::string measure_hint(const MeasureState& measure);

}  // namespace taxel::ui
