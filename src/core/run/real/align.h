// A real recording compared with a simulated run: the shift in time with the largest cross-correlation, the gains and
// offsets between both (least squares), and these gains as the calibration of a layout.
#pragma once

#include <optional>

#include "core/layout/layout.h"
#include "core/run/real/real_recording.h"

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

/// Options of the fit between the readings of a run and those of a real sensor.
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

/// Returns the fits as a table (CSV) with a row for each taxel: `taxel`, `column` of the recording, `gain` with its
/// `gain_unit`, `offset`, `r2`, `rms`, `unit` of offset and RMS, `shift_s`, `points`, and `refused`, the reason why
/// there is no gain. `unit_of_reading` is the unit of the run's readings. Numbers of a refused fit are empty.
std::string fits_csv(const std::vector<TaxelFit>& fits, const ColumnMapping& mapping,
                     const std::string& unit_of_reading, double shift);

/// Returns `before` with the fitted gains. For each taxel with a fitted gain, the gain and the tare replace the former
/// gain, tare and curve of that taxel. The tare gives the fitted offset: recording = gain * (reading - tare), so tare =
/// -offset / gain. All other values remain. `unit` is the unit of the recording; if empty, the former unit remains.
/// Throws Error if no taxel has a gain.
Calibration with_gains(const std::optional<Calibration>& before, const std::vector<TaxelFit>& fits,
                       const std::string& unit);

}  // namespace taxel
