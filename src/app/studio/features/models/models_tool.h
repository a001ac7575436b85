// Asking how other models read the contact.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// The sensor to compare; empty if the panel is closed or no sensor is simulated.
[[nodiscard]] std::optional<ModelsRequest> models_request(const UiState& ui, const UiInput& input);

/// What was found for the sensor that is selected; null: nothing, or not yet.
[[nodiscard]] const ComparedSteps* shown_comparison(const UiState& ui, const UiInput& input);

/// Of one taxel (index) over the compared steps; NaN where there is no value.
[[nodiscard]] std::vector<double> model_curve(const ComparedSteps& compared, ReadingModel model, std::size_t taxel);

/// The taxel whose curves are drawn: the active one, else the one that reads most. Index; -1: there is none.
[[nodiscard]] int compared_taxel(const UiState& ui, const ComparedSteps& compared);

}  // namespace taxel::ui
