// Asking where a reading comes from.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Opens the Explain panel. Where no taxel is selected, the one that changed most since the step before is.
void explain_reading(UiState& ui, const UiInput& input);

/// The taxel to explain; empty if the panel is closed, no taxel is selected, or the layout is edited.
[[nodiscard]] std::optional<ExplainRequest> explain_request(const UiState& ui, const UiInput& input);

/// The explanation of what is selected, in the step that is shown; null: it is not there, or not yet.
[[nodiscard]] const Explanation* shown_explanation(const UiState& ui, const UiInput& input);

/// Selects a polygon of the step that is shown, and shows it; the taxel stays.
void inspect_polygon(UiState& ui, const UiInput& input, PolygonNumber polygon);

}  // namespace taxel::ui
