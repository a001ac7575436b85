// Asking how other models read the contact.
#pragma once

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/features/models/models_state.h"

namespace taxel::ui {

/// The sensor to compare; empty if the panel is closed or no sensor is simulated.
[[nodiscard]] std::optional<ModelsRequest> models_request(const Viewer& viewer, const Shown& shown, bool open);

/// What was found for the sensor that is selected; null: nothing, or not yet.
[[nodiscard]] const ComparedSteps* shown_comparison(const Viewer& viewer, const Shown& shown, const ModelsState& models,
                                                    bool open);

/// Of one taxel (index) over the compared steps; NaN where there is no value.
[[nodiscard]] std::vector<double> model_curve(const ComparedSteps& compared, ReadingModel model, std::size_t taxel);

/// The taxel whose curves are drawn: the active one, else the one that reads most. Index; -1: there is none.
[[nodiscard]] int compared_taxel(const Selection& selection, const ComparedSteps& compared);

}  // namespace taxel::ui
