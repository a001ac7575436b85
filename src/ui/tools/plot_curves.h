// The trace of a run as curves to plot: all of its rows, thinned only to what the screen can show.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/sim/sim_frame.h"
#include "ui/widgets/thin_curve.h"

namespace taxel::ui {

struct PlotCurves {
  const void* trace = nullptr;
  std::size_t rows = 0;
  std::vector<double> x;                      ///< travel [mm] or time [s]
  std::vector<std::vector<double>> readings;  ///< per taxel of all sensors, in SI
  std::vector<double> peaks;                  ///< parallel to readings
  double largest = 0;                         ///< of all [Pa]
  std::optional<double> polished_from;        ///< x from which on the readings are of polished samples; none: all are
  std::vector<CurvePoints> drawn;             ///< parallel to readings; empty: not thinned yet
  std::array<double, 3> drawn_for{};          ///< column, tolerance, scale
};

/// Of another trace, or of one that has got other rows. `by_travel`: over travel, else over time.
void update_curves(PlotCurves& curves, const std::vector<TraceRow>& trace, bool by_travel);

/// One taxel's curve, its readings times `scale`: see thin_curve(). `tolerance` is in scaled readings. Kept until
/// something else is asked for.
const CurvePoints& drawn_curve(PlotCurves& curves, std::size_t reading, double column, double tolerance, double scale);

}  // namespace taxel::ui
