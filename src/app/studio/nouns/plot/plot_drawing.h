// Parts of plots of readings over travel or time: the words for their quantities, axes, curves, the cursor of the run,
// scrubbing, and the legend, whose entries isolate curves.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"

namespace taxel::ui {

/// A quantity in words.
struct QuantityWords {
  const char* key;    ///< word in the dump
  const char* label;  ///< button of the plot
  const char* axis;   ///< name of the vertical axis
  const char* tip;    ///< tooltip of the button
};
[[nodiscard]] const QuantityWords& words_of(PlotQuantity quantity);

// The next five functions draw into the present plot of ImPlot.

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

/// Returns the width that the legend takes [pixels].
[[nodiscard]] float plot_legend_width(const std::vector<ChosenCurve>& curves);

/// The entries of the legend under the pointer.
struct LegendPointer {
  std::optional<TaxelKey> hovered;
  std::optional<TaxelKey> clicked;  ///< clicked curve that was not isolated before
};

/// Returns the tooltip of a curve's entry.
[[nodiscard]] std::string legend_tip(const ChosenCurve& curve);

/// Draws the legend into an area of `size` at the cursor. A click isolates the curve of an entry until the entry is
/// clicked again; Shift adds. `tip` returns the tooltip of an entry.
LegendPointer draw_plot_legend(WindowUi& ui, const std::vector<ChosenCurve>& curves, std::vector<TaxelKey>& isolated,
                               ImVec2 size, const std::function<std::string(const ChosenCurve&)>& tip);

}  // namespace taxel::ui
