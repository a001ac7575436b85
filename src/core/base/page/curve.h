// Curves for the screen and the page: reduced to the points that are visible, and cut at the edges of the axes.
#pragma once

#include <span>
#include <vector>

namespace taxel {

inline constexpr double kCurveTolerance = 0.2;  ///< invisible error of a curve [pixels]

/// Points of a curve.
struct CurvePoints {
  std::vector<double> x, y;
};

/// Reduces a curve whose x never decreases, in two steps. In each column of width `column`, the first, the lowest, the
/// highest and the last point remain (Jugel et al. 2014). Of these points, only those remain that are more than
/// `tolerance` (in y) from straight lines between the others (Bristol 1990). `column` is in the unit of x, `tolerance`
/// in the unit of y. Replaces `out` and reuses its memory.
void thin_curve(std::span<const double> x, std::span<const double> y, double column, double tolerance,
                CurvePoints& out);

/// Reduces a curve whose x may turn back, such as a loop of hysteresis: each part between two turns by thin_curve().
CurvePoints thin_path(std::span<const double> x, std::span<const double> y, double column, double tolerance);

/// A rectangle in the units of a curve.
struct CurveBounds {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
};

/// Returns the parts of a curve inside of the bounds. A point of NaN separates two parts. A point that is not finite
/// interrupts the curve. Segments are cut by the algorithm of Liang and Barsky (1984). A curve of one point remains if
/// the point is inside.
[[nodiscard]] CurvePoints clip_curve(const CurvePoints& curve, const CurveBounds& bounds);

}  // namespace taxel
