// The parameters of a layout and of an object with which simulated readings agree best with recorded ones: bounded
// nonlinear least squares over readings of many poses (read_poses()). docs/theory/run.md has the equations.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/run/fit/fit_values.h"

namespace taxel {

struct RecordingFitOptions {
  std::vector<FitName> free;     ///< parameters that vary; the others keep their values
  std::vector<FitValue> values;  ///< starts of free parameters, and values of others
  int axis = 2;                  ///< axis along which the object presses
  bool shares_gain = false;      ///< one gain of a taxel for all recordings
  int threads = 0;               ///< largest number of threads; 0 for all cores
  Progress* progress = nullptr;  ///< gets the progress and may cancel; or null
};

/// Fits the free parameters to `fitted`, and then the zeros and gains alone to each of `held_out`. Gains are
/// eliminated (variable projection, Golub and Pereyra 1973), the others found by the method of Levenberg and Marquardt
/// within bounds from several starts. Throws Error: a parameter is free twice or needs a size that the case lacks, a
/// taxel is not in the layout, no pose touches, a recording has less points than parameters; and Cancelled.
RecordingFit fit_recordings(const FitSubject& subject, const std::vector<PressedRecording>& fitted,
                            const std::vector<PressedRecording>& held_out, const RecordingFitOptions& options);

}  // namespace taxel
