// The probe tool: grabs a probe, moves the probe over the skin, sets its depth and places it.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_state.h"

namespace taxel::ui {

/// Largest depth of the probe, as a fraction of the sensor's size.
inline constexpr double kDeepestProbe = 0.5;

[[nodiscard]] bool can_probe(const Viewer& viewer, const DocumentView& document);
/// Activates or deactivates the probe tool. Returns whether the tool was activated.
bool toggle_probe(const Viewer& viewer, const DocumentView& document, ProbeState& probe);
void leave_probe(ProbeState& probe);

/// Returns the probe to press, or nothing.
[[nodiscard]] std::optional<Probe> probe_request(const Viewer& viewer, const ProbeState& state);

/// Handles the view's mouse before other tools and the camera. Returns whether the probe tool consumed the event.
bool handle_probe_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                        ProbeState& probe, const PointerEvent& event);

/// Returns the change of depth per notch of the wheel [m] on a sensor with a bounding box of this diagonal [m]: 1, 2 or
/// 5 times a power of ten.
[[nodiscard]] double probe_notch(double diagonal);

struct ToggleProbe {};

/// Changes to LAYOUT and starts the probe.
struct ProbeInLayout {};
void carry_out(const ToggleProbe& command, App& app);
void carry_out(const ProbeInLayout& command, App& app);

}  // namespace taxel::ui
