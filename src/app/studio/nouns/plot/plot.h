// The plot of readings over travel, as in Figure 4 of the paper: divided by the largest reading of the run, or in kPa.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"

namespace taxel::ui {
/// Readings over travel or time.
extern const Feature kPlot;
/// Sets "plot": the drawn curves and the values at the pointer.
void dump_plot(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
