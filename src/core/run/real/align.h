// Time alignment of a real recording with a simulated run: the shift with the largest cross-correlation.
#pragma once

#include <optional>

#include "core/run/real/taxel_series.h"

namespace taxel {

/// The best shift of a recording, and its quality.
struct Alignment {
  double shift = 0;        ///< time to add to the times of the recording [s]
  double correlation = 0;  ///< mean over the taxels of Pearson's coefficient at this shift
  double overlap = 0;      ///< duration in which both signals have values at this shift [s]
};

/// Smallest fraction of the shorter signal that must overlap with the other signal.
inline constexpr double kLeastOverlap = 0.5;

/// Returns the shift that maximises the cross-correlation, or nothing if no shift has enough overlap or all taxels of
/// one signal are constant. The cross-correlation is the mean, over the taxels that respond in both signals, of
/// Pearson's coefficient over the overlap; it does not depend on gains, on offsets, or on how much noise widens the
/// range of a taxel.
///
/// Shifts with at least kLeastOverlap are searched in three steps: on a coarse grid, on the grid of the finer signal
/// around the best coarse shift, and between the points of that grid by a parabola through the best point and its
/// neighbours. For signals that are smooth on their grid, the error is a small fraction of an interval. Cost: at most
/// about ten million products for each taxel.
std::optional<Alignment> align(const TaxelSeries& run, const TaxelSeries& real);

}  // namespace taxel
