// The files of a fit: charts and the table of points.
#pragma once

#include <string>
#include <vector>

#include "core/base/page/chart.h"
#include "core/run/fit/fit_values.h"

namespace taxel {

/// Returns the values at the ends of presses across the taxels, a panel for each recording: recorded ones as rings,
/// fitted ones as curves. `recordings` are those of the fit, in the order of its runs.
[[nodiscard]] Chart bells_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings);
/// Returns the values over the travel of the press at which each taxel responds most, a panel for each recording.
[[nodiscard]] Chart loading_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings, int axis);
/// Returns the errors over the recorded values, both relative to the largest one, a panel for each recording.
[[nodiscard]] Chart residuals_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings);

/// Returns a table (CSV) with a row for each point: run, press and row from 0, x, y, z [m] with the fitted zero, taxel,
/// measured, fitted and residual in the unit of the recording.
[[nodiscard]] std::string points_csv(const RecordingFit& fit, const std::vector<PressedRecording>& recordings);

}  // namespace taxel
