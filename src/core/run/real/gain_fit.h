// Least-squares fit of gain and offset between the readings of a run and those of a real sensor, for each taxel or for
// all taxels together.
#pragma once

#include "core/run/real/taxel_series.h"

namespace taxel {

struct FitOptions {
  bool common = false;  ///< one gain and one offset for all taxels
  bool offset = true;   ///< fits an offset; if false, the line passes through 0
};

/// Result for one taxel: real = gain * run + offset.
struct TaxelFit {
  int taxel = 0;
  std::string refused;       ///< reason why there is no gain; empty if there is one
  double gain = 0;           ///< [unit of real / unit of run]
  double offset = 0;         ///< [unit of real]
  double r2 = 0;             ///< R^2 = 1 - residual squares / squares about the mean (about 0 without an offset)
  double residual = 0;       ///< root mean square of real - (gain run + offset) [unit of real]
  double largest_error = 0;  ///< largest absolute value of real - (gain run + offset) [unit of real]
  std::size_t points = 0;    ///< number of pairs of values
};

/// Smallest R^2 of a fit. Below it the recording does not follow the run, and the gain would be a matter of chance.
inline constexpr double kFollows = 0.1;

/// Returns one fit for each taxel that both series have, in the order of the run. `shift` [s] is added to the times of
/// the recording. A fit uses the times of the run at which the recording has a value, and solves the normal equations
/// in closed form. A taxel has a reason instead of a gain if it does not respond in the run, is constant in the
/// recording, or does not follow the run (R^2 below kFollows).
std::vector<TaxelFit> fit_gains(const TaxelSeries& run, const TaxelSeries& real, double shift,
                                const FitOptions& options);

/// Returns the recorded values of a taxel at the times of the run; NaN where the recording has no value.
std::vector<double> on_run_times(const TaxelSeries& run, const TaxelSeries& real, int taxel, double shift);

/// Returns a table `time,taxel_<id>,real_<id>,fitted_<id>...` with a row for each time of the run: the simulated
/// reading, the recorded value, and gain * reading + offset. Fields are empty where the recording has no value;
/// `fitted` is also empty without a gain.
std::string aligned_csv(const TaxelSeries& run, const TaxelSeries& real, double shift,
                        const std::vector<TaxelFit>& fits);

}  // namespace taxel
