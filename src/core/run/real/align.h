// When a real recording begins on the clock of a run: the shift at which the two look most alike.
#pragma once

#include <optional>

#include "core/run/real/taxel_series.h"

namespace taxel {

struct Alignment {
  double shift = 0;        ///< to be added to the recording's times, so that they are the run's [s]
  double correlation = 0;  ///< there: mean of Pearson's over the taxels
  double overlap = 0;      ///< time that both cover then, with values [s]
};

/// Part of the shorter one of two signals that must lie over the other one.
inline constexpr double kLeastOverlap = 0.5;

/// The shift that maximises the cross-correlation: the mean, over the taxels that respond in both, of Pearson's
/// coefficient over the overlap, so that neither gain nor offset of a taxel counts, nor how noise widens its range. Of
/// all shifts with which at least kLeastOverlap of the shorter signal overlaps: first on a coarse grid, then on that of
/// the finer signal around the best one, then between its points by the parabola through the best and its neighbours.
/// For signals that are smooth on their grid the error is a small part of an interval. None where no shift has enough
/// overlap, or the taxels of one signal are constant. Cost: some ten million products a taxel at most.
std::optional<Alignment> align(const TaxelSeries& run, const TaxelSeries& real);

}  // namespace taxel
