// The hand that holds a probe: takes it up, leads it over the skin, sets its depth, puts it down.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// The most depth, parts of the sensor's size.
inline constexpr double kDeepestProbe = 0.5;

[[nodiscard]] bool can_probe(const UiState& ui, const UiInput& input);
/// Takes the probe up, or leaves it.
void toggle_probe(UiState& ui, const UiInput& input);
void leave_probe(UiState& ui);

/// Returns the probe to press, or nothing.
[[nodiscard]] std::optional<Probe> probe_request(const UiState& ui);

/// The view's mouse, before other tools and the camera get it. x, y: pointer in pixels of the view. True: it is the
/// probe's.
bool handle_probe_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered);

/// By how much one notch of the wheel changes the depth on a sensor of this size: 1, 2 or 5 times a power of ten. [m]
[[nodiscard]] double probe_notch(double diagonal);

}  // namespace taxel::ui
