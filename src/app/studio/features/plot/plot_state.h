// The plot of readings: its options and its curves.
#pragma once

#include "app/studio/features/plot/plot_curves.h"

namespace taxel::ui {

struct PlotOptions {
  bool relative = true;         ///< plot fractions of the run's largest reading (Figure 4) instead of kPa
  bool responding_only = true;  ///< only taxels above 5 % of the largest reading
};

struct PlotState {
  PlotOptions options;
  PlotCurves curves;
};

}  // namespace taxel::ui
