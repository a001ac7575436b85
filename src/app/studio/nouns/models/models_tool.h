// Requests for the readings of the contact by other models.
#pragma once

#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/models/models_state.h"

namespace taxel::ui {

/// Returns the sensor to compare; empty if the panel is closed or no sensor is simulated.
[[nodiscard]] std::optional<ModelsRequest> models_request(const Viewer& viewer, const Shown& shown, bool open);

/// Returns the comparison of the selected sensor; null if there is none, or not yet.
[[nodiscard]] const ComparedSteps* shown_comparison(const Viewer& viewer, const Shown& shown, const ModelsState& models,
                                                    bool open);

/// Returns the readings of one taxel (index) over the compared steps; NaN for steps without a value.
[[nodiscard]] std::vector<double> model_curve(const ComparedSteps& compared, ReadingModel model, std::size_t taxel);

/// Returns the index of the taxel whose curves are drawn: the active taxel, otherwise the taxel with the largest
/// reading; -1 if there is none.
[[nodiscard]] int compared_taxel(const Selection& selection, const ComparedSteps& compared);

}  // namespace taxel::ui
