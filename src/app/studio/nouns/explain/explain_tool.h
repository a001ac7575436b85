// Requests for the explanation of a reading.
#pragma once

#include "app/studio/frame/command.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/explain/explain_state.h"

namespace taxel::ui {

/// Opens the Explain panel. If no taxel is selected, selects the taxel that changed most since the previous step.
void explain_reading(Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open);

/// Returns the taxel to explain; empty if the panel is closed, no taxel is selected, or the layout is edited.
[[nodiscard]] std::optional<ExplainRequest> explain_request(const Viewer& viewer, const Shown& shown, bool open);

/// Returns the explanation of the selected taxel in the displayed step; null if there is none, or not yet.
[[nodiscard]] const Explanation* shown_explanation(const Viewer& viewer, const Shown& shown,
                                                   const ExplainState& explain, bool open);

/// Selects a polygon of the displayed step and opens the panel. The selected taxel stays.
void inspect_polygon(const RunView& run, ExplainState& explain, bool& open, PolygonNumber polygon);

struct ExplainReading {};
void carry_out(const ExplainReading& command, App& app);

}  // namespace taxel::ui
