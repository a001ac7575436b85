// Splits curves into dashes of equal length on the screen.
#pragma once

#include "core/base/page/thin_curve.h"

namespace taxel::ui {

/// Lengths of a dash and of the gap after it [pixels].
struct DashLengths {
  double dash = 6, gap = 4;
  double start = 0;  ///< place in the pattern at which the curve begins [pixels]
};

/// Returns the dashes of a curve in the units of the curve, with a point of NaN after each dash. Dashes and gaps
/// continue around the corners of the curve. `x_scale` and `y_scale` are the pixels per unit of x and y.
CurvePoints dashes_of(const CurvePoints& curve, double x_scale, double y_scale, const DashLengths& lengths);

}  // namespace taxel::ui
