#include "core/base/page/clip_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace taxel {
namespace {

/// Returns the range of t in [0, 1] for which from + t * change is between low and high, within `range`.
std::optional<std::pair<double, double>> narrowed(std::pair<double, double> range, double from, double change,
                                                  double low, double high) {
  if (change == 0) return from >= low && from <= high ? std::optional(range) : std::nullopt;
  double enter = (low - from) / change, leave = (high - from) / change;
  if (enter > leave) std::swap(enter, leave);
  range.first = std::max(range.first, enter), range.second = std::min(range.second, leave);
  return range.first <= range.second ? std::optional(range) : std::nullopt;
}

void add_point(CurvePoints& out, double x, double y) {
  if (!out.x.empty() && out.x.back() == x && out.y.back() == y) return;
  out.x.push_back(x), out.y.push_back(y);
}

void add_break(CurvePoints& out) {
  constexpr double kBreak = std::numeric_limits<double>::quiet_NaN();
  if (!out.x.empty() && std::isfinite(out.x.back())) out.x.push_back(kBreak), out.y.push_back(kBreak);
}

}  // namespace

CurvePoints clip_curve(const CurvePoints& curve, const CurveBounds& bounds) {
  CurvePoints out;
  const auto is_inside = [&](double x, double y) {
    return x >= bounds.x_low && x <= bounds.x_high && y >= bounds.y_low && y <= bounds.y_high;
  };
  if (curve.x.size() == 1 && is_inside(curve.x[0], curve.y[0])) add_point(out, curve.x[0], curve.y[0]);
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    const double x = curve.x[i - 1], y = curve.y[i - 1], dx = curve.x[i] - x, dy = curve.y[i] - y;
    if (!std::isfinite(dx) || !std::isfinite(dy)) {
      add_break(out);
      continue;
    }
    auto range = narrowed({0, 1}, x, dx, bounds.x_low, bounds.x_high);
    if (range) range = narrowed(*range, y, dy, bounds.y_low, bounds.y_high);
    if (!range) {
      add_break(out);
      continue;
    }
    if (range->first > 0) add_break(out);
    const auto [first, last] = *range;
    add_point(out, x + first * dx, y + first * dy);
    last < 1 ? add_point(out, x + last * dx, y + last * dy) : add_point(out, curve.x[i], curve.y[i]);
  }
  return out;
}

}  // namespace taxel
