// Parts of plots of readings over travel or time: axes, curves, the cursor of the run and scrubbing.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_page.h"

namespace taxel::ui {

// All functions draw into the present plot of ImPlot.

/// Sets names and ends of the axes of a plot of this height [pixels], and ends the setup.
void setup_plot_axes(const PlotAxes& axes, float height);
/// Draws a curve, thinned to the resolution of the screen. `scale` converts SI units to the vertical axis.
void draw_plot_curve(const WindowUi& ui, PlotCurves& curves, const ChosenCurve& curve, const CurveStyle& style,
                     double scale);
/// Draws the error bar of each curve at the displayed step. `scale` as for draw_plot_curve(). Returns their number.
int draw_plot_errors(const WindowUi& ui, const RunView& run, const std::vector<SensorShown>& sensors,
                     const std::vector<ChosenCurve>& curves, double scale);
/// Draws a line at the displayed step.
void draw_plot_cursor(const WindowUi& ui, const RunView& run);
/// Displays the recorded step under a click or a drag.
void scrub_in_plot(WindowUi& ui, const RunView& run);

}  // namespace taxel::ui
