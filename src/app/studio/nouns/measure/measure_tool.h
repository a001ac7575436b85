// The measure tool: two clicks on the surface, and their distance, straight and along the surface.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_state.h"

namespace taxel::ui {

[[nodiscard]] bool can_measure(const Viewer& viewer, const DocumentView& document);
/// Begins or ends measuring. Returns whether measuring was begun.
bool toggle_measure(const Viewer& viewer, const DocumentView& document, MeasureState& measure);
void leave_measure(MeasureState& measure);

/// Returns the distance to measure, or nothing with fewer than two points.
[[nodiscard]] std::optional<MeasureRequest> measure_request(const Viewer& viewer, const DocumentView& document,
                                                            const MeasureState& measure);

/// Handles the view's mouse before other tools and the camera. Returns whether the measure tool consumed the event.
bool handle_measure_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                          MeasureState& measure, const SceneInput& scene, const PointerEvent& event);

struct ToggleMeasure {};
void carry_out(const ToggleMeasure& command, App& app);

}  // namespace taxel::ui
