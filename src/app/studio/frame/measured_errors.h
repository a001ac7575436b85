// Error bars of the readings of one step, as the window measured them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/run/step.h"

namespace taxel::ui {

/// The bars of all sensors of a scene in one step; see core/sim/compare/error_bars.h.
struct MeasuredErrors {
  StepId id;                              ///< measured step
  std::vector<std::vector<double>> bars;  ///< bars of each sensor, in SI units; empty for a sensor without bars
  std::vector<std::string> missing;       ///< why a sensor has no bars; empty if it has
  std::string problem;                    ///< why no sensor has bars; empty if they were measured
};
using MeasuredErrorsPtr = std::shared_ptr<const MeasuredErrors>;

}  // namespace taxel::ui
