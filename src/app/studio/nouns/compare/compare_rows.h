// The rows of a comparison of two layouts: readings of both in the same step, their curves and their numbers.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/studio/nouns/plot/plot_curves.h"
#include "core/run/trace.h"

namespace taxel::ui {

/// The readings of both layouts in one step.
struct ComparedRow {
  std::uint64_t step = 0;
  double time = 0, travel = 0;                  ///< [s], [m]
  std::array<std::vector<double>, 2> readings;  ///< readings of A, the layout of the run, and of B, in SI units
  /// Whether rows of the run are missing between the previous row and this row.
  bool after_gap = false;
};
using ComparedRowPtr = std::shared_ptr<const ComparedRow>;

/// A reading of one taxel in one row.
struct RowReading {
  double value = 0;  ///< in SI units
  int taxel = -1;    ///< index of the taxel, or -1 if all values are 0
  double x = 0;      ///< travel [m] or time [s] of the row
};

/// The numbers of one layout over the compared rows.
struct SideSummary {
  RowReading peak;            ///< largest reading
  RowReading jump;            ///< largest change of a reading between two neighbouring rows, at the later row
  int responding = 0;         ///< number of taxels whose peak is above kTaxelResponds of the largest
  std::vector<double> peaks;  ///< largest reading of each taxel
};

/// The curves and the numbers of one layout.
struct CompareSide {
  Trace trace;
  PlotCurves curves;
  SideSummary summary;
};

/// Adds the readings of row `rows[i]` from the first row that `side` does not have. The side must have been filled from
/// the beginning of `rows`. `which` is 0 for A and 1 for B.
void extend_side(CompareSide& side, std::span<const ComparedRowPtr> rows, std::size_t which, bool by_travel);

/// Returns the mean distance between neighbouring rows: travel [m] or time [s]. 0 with less than two rows.
[[nodiscard]] double row_distance(std::span<const ComparedRowPtr> rows, bool by_travel);

/// Returns a table `time,travel,A/taxel_<id>...,B/taxel_<id>...` in SI units. Every number is in the shortest form that
/// reads back exactly.
[[nodiscard]] std::string comparison_to_csv(std::span<const ComparedRowPtr> rows, const std::vector<int>& ids_a,
                                            const std::vector<int>& ids_b);

}  // namespace taxel::ui
