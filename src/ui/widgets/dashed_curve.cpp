#include "ui/widgets/dashed_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taxel::ui {

CurvePoints dashes_of(const CurvePoints& curve, double x_scale, double y_scale, const DashLengths& lengths) {
  constexpr double kMaxLength = 1e5;   // longest dashed piece of a curve [pixels]; longer pieces leave the plot
  constexpr double kLeastStep = 0.05;  // smallest step of the loop [pixels], so that rounding cannot stop it
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  CurvePoints dashes;
  const auto add = [&](double x, double y) { dashes.x.push_back(x), dashes.y.push_back(y); };
  const double period = lengths.dash + lengths.gap;
  double drawn = std::fmod(lengths.start, period);  // length since the beginning of the last dash
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    const double dx = curve.x[i] - curve.x[i - 1], dy = curve.y[i] - curve.y[i - 1];
    const double length = std::hypot(x_scale * dx, y_scale * dy);
    if (!(length > 0) || length > kMaxLength) continue;
    for (double at = 0; at < length;) {
      const double phase = std::fmod(drawn + at, period);
      const bool is_dash = phase < lengths.dash;
      const double end = std::min(length, at + std::max(kLeastStep, (is_dash ? lengths.dash : period) - phase));
      if (is_dash) {
        if (dashes.x.empty() || std::isnan(dashes.x.back()))
          add(curve.x[i - 1] + at / length * dx, curve.y[i - 1] + at / length * dy);
        add(curve.x[i - 1] + end / length * dx, curve.y[i - 1] + end / length * dy);
      } else if (!dashes.x.empty() && !std::isnan(dashes.x.back())) {
        add(kGap, kGap);
      }
      at = end;
    }
    drawn = std::fmod(drawn + length, period);
  }
  return dashes;
}

}  // namespace taxel::ui
