// Curves of many points, reduced to what can be told apart on the screen.
#pragma once

#include <span>
#include <vector>

namespace taxel::ui {

inline constexpr double kCurveTolerance = 0.2;  ///< [pixels]: less than can be told apart

struct CurvePoints {
  std::vector<double> x, y;
};

/// Of a curve with x that never falls: in each column of that width the first, the lowest, the highest and the last
/// point (Jugel et al. 2014), and of those only the ones that straight lines between the others miss by more than
/// `tolerance` (in y; Bristol 1990). Replaces `out`, keeps its memory. Units are those of x and y.
void thin_curve(std::span<const double> x, std::span<const double> y, double column, double tolerance,
                CurvePoints& out);

}  // namespace taxel::ui
