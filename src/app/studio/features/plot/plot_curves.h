// The trace of a run as curves to plot: all of its rows, thinned only to what the screen can show.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/run/trace.h"
#include "ui/widgets/thin_curve.h"

namespace taxel::ui {

struct PlotCurves {
  std::uint64_t edition = 0;  ///< of the trace
  bool by_travel = false;
  std::vector<double> x;                      ///< travel [mm] or time [s]
  std::vector<std::vector<double>> readings;  ///< per taxel of all sensors, in SI
  std::vector<double> peaks;                  ///< parallel to readings
  double largest = 0;                         ///< of all [Pa]
  std::optional<double> polished_from;        ///< x from which on the readings are of polished samples; none: all are
  std::vector<CurvePoints> drawn;             ///< parallel to readings; empty: not thinned yet
  std::array<double, 3> drawn_for{};          ///< column, tolerance, scale
  std::vector<std::size_t> paired;            ///< readings among which `leaders` were looked for
  std::vector<int> leaders;                   ///< parallel to `paired`: see find_leaders()
  std::size_t paired_rows = 0;                ///< number of rows of which `leaders` are
  bool is_growing = false;                    ///< the last update added rows
};

/// Those of a trace: of the one they are of, only new rows are looked at. `by_travel`: over travel, else over time.
void update_curves(PlotCurves& curves, const Trace& trace, bool by_travel);

/// One taxel's curve, its readings times `scale`: see thin_curve(). `tolerance` is in scaled readings. Kept until
/// something else is asked for.
const CurvePoints& drawn_curve(PlotCurves& curves, std::size_t reading, double column, double tolerance, double scale);

/// For each of `readings` the index in `readings` of the curve that it follows, or -1: see find_leaders(). While rows
/// are added the reply may be that of up to a tenth fewer rows.
const std::vector<int>& leaders_among(PlotCurves& curves, const std::vector<std::size_t>& readings);

}  // namespace taxel::ui
