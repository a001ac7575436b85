// Gain and offset between what a run reads and what a real sensor gave: least squares, taxel by taxel or for all at
// once.
#pragma once

#include "core/run/real/taxel_series.h"

namespace taxel {

struct FitOptions {
  bool common = false;  ///< one gain and one offset for all taxels
  bool offset = true;   ///< else the line goes through 0
};

/// real = gain * run + offset.
struct TaxelFit {
  int taxel = 0;
  std::string refused;       ///< why there is no gain; empty: there is one
  double gain = 0;           ///< [unit of real / unit of run]
  double offset = 0;         ///< [unit of real]
  double r2 = 0;             ///< 1 - residual squares / squares about the mean (through 0: about 0)
  double residual = 0;       ///< root mean square of real - (gain run + offset) [unit of real]
  double largest_error = 0;  ///< likewise the largest
  std::size_t points = 0;    ///< pairs of values
};

/// Below it the recording does not follow the run, and a gain would be chance.
inline constexpr double kFollows = 0.1;

/// One fit for each taxel that both series have, in the run's order, over the run's times at which the recording, its
/// times moved by `shift` [s], has a value. Closed form of the normal equations. Taxels that do not respond in the run,
/// are constant in the recording or do not follow the run (R^2 below kFollows) have no gain but a reason.
std::vector<TaxelFit> fit_gains(const TaxelSeries& run, const TaxelSeries& real, double shift,
                                const FitOptions& options);

/// The recording's values of a taxel at the run's times; NaN where there are none.
std::vector<double> on_run_times(const TaxelSeries& run, const TaxelSeries& real, int taxel, double shift);

/// `time,taxel_<id>,real_<id>,fitted_<id>...` on the run's times: what was read, what the real sensor gave, and
/// gain * read + offset (empty without a gain); empty fields where the recording has nothing.
std::string aligned_csv(const TaxelSeries& run, const TaxelSeries& real, double shift,
                        const std::vector<TaxelFit>& fits);

}  // namespace taxel
