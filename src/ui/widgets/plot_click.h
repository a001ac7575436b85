// Detection of clicks in plots.
#pragma once

namespace taxel::ui {

/// Returns true if the user clicks within the axes of the plot that is being drawn. ImPlot::IsPlotHovered cannot be
/// used, because it is false while the button is down.
bool plot_clicked();

}  // namespace taxel::ui
