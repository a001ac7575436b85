// Cuts a curve at the edges of the axes.
#pragma once

#include "core/base/page/thin_curve.h"

namespace taxel {

/// A rectangle in the units of a curve.
struct CurveBounds {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
};

/// Returns the parts of a curve inside of the bounds. A point of NaN separates two parts. A point that is not finite
/// interrupts the curve. Segments are cut by the algorithm of Liang and Barsky (1984). A curve of one point remains if
/// the point is inside.
[[nodiscard]] CurvePoints clip_curve(const CurvePoints& curve, const CurveBounds& bounds);

}  // namespace taxel
