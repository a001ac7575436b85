// Clicks in plots.
#pragma once

namespace taxel::ui {

/// Whether the plot that is being drawn was clicked within its axes. (ImPlot::IsPlotHovered is false while the button
/// is down.)
bool plot_clicked();

}  // namespace taxel::ui
