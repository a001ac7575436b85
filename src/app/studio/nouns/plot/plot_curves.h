// The trace of a run as curves to plot: all rows, thinned only to the resolution of the screen.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "app/studio/nouns/plot/plot_quantity.h"
#include "core/base/page/thin_curve.h"
#include "core/run/trace.h"

namespace taxel::ui {

struct PlotCurves {
  std::uint64_t edition = 0;  ///< edition of the plotted trace
  bool by_travel = false;
  PlotQuantity quantity = PlotQuantity::reading;
  std::vector<double> x;                      ///< travel [mm] or time [s]
  std::vector<std::vector<double>> readings;  ///< values of each taxel of all sensors, in SI units
  std::vector<double> peaks;                  ///< parallel to `readings`
  double largest = 0;                         ///< largest of all readings [Pa]
  std::optional<double> polished_from;        ///< first x with polished samples; empty if all are polished
  std::vector<CurvePoints> drawn;             ///< parallel to `readings`; an empty entry is not thinned yet
  std::array<double, 3> drawn_for{};          ///< column, tolerance and scale of `drawn`
  std::vector<std::size_t> paired;            ///< readings that were searched for `leaders`
  std::vector<int> leaders;                   ///< parallel to `paired`: see find_leaders()
  std::size_t paired_rows = 0;                ///< number of rows that were searched for `leaders`
  bool is_growing = false;                    ///< whether the last update added rows
};

/// Updates the curves from a trace. If the trace only grew since the last update, only new rows are read. Curves are
/// over travel if `by_travel`, otherwise over time. Rows without the quantity have the value 0.
void update_curves(PlotCurves& curves, const Trace& trace, bool by_travel,
                   PlotQuantity quantity = PlotQuantity::reading);

/// Returns the curve of one taxel with its readings times `scale`; see thin_curve(). `tolerance` is in scaled readings.
/// The result is retained until a call with other arguments.
const CurvePoints& drawn_curve(PlotCurves& curves, std::size_t reading, double column, double tolerance, double scale);

/// Returns, for each of `readings`, the index in `readings` of the curve that it follows, or -1; see find_leaders().
/// `twins` is called for a new search. While rows are added, the result may be based on up to a tenth fewer rows.
const std::vector<int>& leaders_among(PlotCurves& curves, const std::vector<std::size_t>& readings,
                                      const std::function<std::vector<int>()>& twins = nullptr);

}  // namespace taxel::ui
