// Two clicks on the surface, and how far they are apart: straight and along it.
#pragma once

#include "app/studio/app/pointing/pointer_event.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/measure/measure_state.h"

namespace taxel::ui {

/// Begins to measure, or ends it. Returns whether it was begun.
bool toggle_measure(const Viewer& viewer, const DocumentView& document, MeasureState& measure);
void leave_measure(MeasureState& measure);

/// The distance to measure, or empty with fewer than two points.
[[nodiscard]] std::optional<MeasureRequest> measure_request(const Viewer& viewer, const DocumentView& document,
                                                            const MeasureState& measure);

/// The view's mouse, before other tools and the camera get it. True: it is the measure's.
bool handle_measure_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                          MeasureState& measure, const SceneInput& scene, const PointerEvent& event);

}  // namespace taxel::ui
