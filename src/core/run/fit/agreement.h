// The agreement of simulated readings with a recording.
#pragma once

#include <cmath>
#include <vector>

#include "core/run/fit/fit_values.h"

namespace taxel {

/// A row of a recording and the press that it belongs to.
struct FitRow {
  std::size_t press = 0, row = 0;
};

/// Returns the recorded value of a taxel without the baseline of its press; NaN if it is missing.
inline double measured_at(const PressedRecording& recording, const FitRow& row, std::size_t taxel) {
  return recording.values[taxel][row.row] - recording.presses[row.press].baseline[taxel];
}

/// Returns the agreement of a recording. `simulated` has the readings of its taxels, row by row of `rows`. `axis` is
/// the pressing axis.
RunAgreement agreement_of(const PressedRecording& recording, const std::vector<FitRow>& rows, const dvec3& zero,
                          const std::vector<double>& simulated, const std::vector<double>& gains, int axis);

/// Returns the width at half height of a bell: the distance between the places at both sides of its peak at which the
/// value is half of the peak, by linear interpolation; NaN if a side does not fall to half. `places` ascend.
double half_width(const std::vector<double>& places, const std::vector<double>& values);

/// Returns the parameters on which nothing depends, and the pairs whose correlation is beyond kUndecided.
std::vector<Undecided> undecided_of(const std::vector<FittedParameter>& parameters,
                                    const std::vector<std::vector<double>>& correlations);

}  // namespace taxel
