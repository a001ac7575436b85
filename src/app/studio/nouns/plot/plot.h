// The plot of readings over travel, as in Figure 4 of the paper: divided by the largest reading of the run, or in kPa.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Readings over travel or time.
extern const Feature kPlot;
/// Sets "plot": the drawn curves and the values at the pointer.
void dump_plot(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
