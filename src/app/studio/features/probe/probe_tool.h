// The hand that holds a probe: takes it up, leads it over the skin, sets its depth, puts it down.
#pragma once

#include "app/studio/app/pointing/pointer_event.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/probe/probe_state.h"

namespace taxel::ui {

/// The most depth, parts of the sensor's size.
inline constexpr double kDeepestProbe = 0.5;

[[nodiscard]] bool can_probe(const Viewer& viewer, const DocumentView& document);
/// Takes the probe up, or leaves it. Returns whether the probe was taken up.
bool toggle_probe(const Viewer& viewer, const DocumentView& document, ProbeState& probe);
void leave_probe(ProbeState& probe);

/// Returns the probe to press, or nothing.
[[nodiscard]] std::optional<Probe> probe_request(const Viewer& viewer, const ProbeState& state);

/// The view's mouse, before other tools and the camera get it. x, y: pointer in pixels of the view. True: it is the
/// probe's.
bool handle_probe_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                        ProbeState& probe, const PointerEvent& event);

/// By how much one notch of the wheel changes the depth on a sensor of this size: 1, 2 or 5 times a power of ten. [m]
[[nodiscard]] double probe_notch(double diagonal);

}  // namespace taxel::ui
