// Two clicks on the surface, and how far they are apart: straight and along it.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void toggle_measure(UiState& ui, const UiInput& input);
void leave_measure(UiState& ui);

/// The distance to measure, or empty with fewer than two points.
[[nodiscard]] std::optional<MeasureRequest> measure_request(const UiState& ui, const UiInput& input);

/// The view's mouse, before other tools and the camera get it. True: it is the measure's.
bool handle_measure_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered);

}  // namespace taxel::ui
