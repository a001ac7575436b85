// When a real recording begins on the clock of a run: the shift at which the two look most alike.
#pragma once

#include <optional>

#include "core/project/real_recording/taxel_series.h"

namespace taxel {

/// One number over time, on an even grid.
struct EvenSignal {
  double start = 0, interval = 0;  ///< [s]
  std::vector<double> values;      ///< NaN: missing
};

struct Alignment {
  double shift = 0;        ///< to be added to the recording's times, so that they are the run's [s]
  double correlation = 0;  ///< Pearson's, there
  double overlap = 0;      ///< time that both cover then, with values [s]
};

/// Part of the shorter one of two signals that must lie over the other one.
inline constexpr double kLeastOverlap = 0.5;
/// A taxel responds where its range is above this part of the largest one.
inline constexpr double kTaxelResponds = 0.05;

/// The sum of the taxels `ids` that respond, each divided by its range, so that none drowns the others; every
/// `interval`. Missing where one of them is.
EvenSignal summed_signal(const TaxelSeries& series, const std::vector<int>& ids, double interval);

/// The shift that maximises the cross-correlation, normalised over the overlap (Pearson's coefficient), of all with
/// which at least kLeastOverlap of the shorter signal overlaps: first on a coarse grid, then on that of the finer
/// signal around the best one, then between its points by the parabola through the best and its neighbours. For signals
/// that are smooth on their grid the error is a small part of an interval. None where no shift has enough overlap, or
/// one signal is constant. Cost: coarse points squared, at most some ten million products.
std::optional<Alignment> align(const TaxelSeries& run, const TaxelSeries& real);

}  // namespace taxel
