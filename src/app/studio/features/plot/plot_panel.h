// The plot of readings over travel, as in Figure 4 of the paper: divided by the largest reading of the run, or in kPa.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/plot/plot_state.h"
#include "app/studio/features/real/real_state.h"

namespace taxel::ui {
void draw_plot_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, RealState& real, PlotState& plot, bool& open);
}  // namespace taxel::ui
