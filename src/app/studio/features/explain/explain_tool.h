// Asking where a reading comes from.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/features/explain/explain_state.h"

namespace taxel::ui {

/// Opens the Explain panel. Where no taxel is selected, the one that changed most since the step before is.
void explain_reading(Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open);

/// The taxel to explain; empty if the panel is closed, no taxel is selected, or the layout is edited.
[[nodiscard]] std::optional<ExplainRequest> explain_request(const Viewer& viewer, const Shown& shown, bool open);

/// The explanation of what is selected, in the step that is shown; null: it is not there, or not yet.
[[nodiscard]] const Explanation* shown_explanation(const Viewer& viewer, const Shown& shown,
                                                   const ExplainState& explain, bool open);

/// Selects a polygon of the step that is shown, and shows it; the taxel stays.
void inspect_polygon(const RunView& run, ExplainState& explain, bool& open, PolygonNumber polygon);

}  // namespace taxel::ui
