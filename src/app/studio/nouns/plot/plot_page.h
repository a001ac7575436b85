// The plot as a page in vectors, for SVG and PDF files, and the axes that window and page share.
#pragma once

#include <string>
#include <vector>

#include "app/studio/nouns/plot/plot_state.h"
#include "core/base/page/page.h"

namespace taxel::ui {

/// Names and upper ends of the axes, which begin at 0.
struct PlotAxes {
  std::string x_name, y_name;  ///< with their units
  double x_end = 1, y_end = 1;
};

/// Returns the axes of a run: the whole length of its scenario if that is known, otherwise up to the displayed step.
[[nodiscard]] PlotAxes plot_axes(const RunView& run, const PlotChoice& choice, bool relative);

/// Returns the plot on white, with a legend: 6 x 3.6 inches, and wider by the columns of a long legend. Curves that do
/// not stand out from `focus` are pale.
[[nodiscard]] Page plot_page(PlotCurves& curves, const PlotChoice& choice, const std::vector<TaxelKey>& focus,
                             const PlotAxes& axes, bool relative, const std::string& title);

/// Returns the page of the plot as its panel shows it, also if the panel is closed. Empty without curves.
[[nodiscard]] std::optional<Page> displayed_plot(const RunView& run, const Selection& selection, PlotState& plot,
                                                 const std::string& title);

}  // namespace taxel::ui
