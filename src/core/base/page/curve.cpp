// Thinning of curves by columns and a swinging door, and clipping at the edges of the axes.
//
// A curve of a million points on a page of a thousand columns shows no more than the first, the lowest, the highest and
// the last point of each column (Jugel et al. 2014); these remain. Of them, the swinging door (Bristol 1990) keeps only
// those that a straight line between others does not represent: from the last kept point, the range of slopes that pass
// each later point within the tolerance becomes narrower, until a new point has no slope in it. Both are one pass,
// O(n), and the error is below the tolerance.
//
// Segments are clipped by the range of their parameter within the bounds (Liang, Barsky 1984). Points that are no
// numbers interrupt a curve. Pitfall: a vertical piece has no slope, so both of its ends are kept.
#include "core/base/page/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace taxel {
namespace {

/// Swinging-door algorithm: a line from the last retained point represents all later points as long as there is one
/// slope that misses each of them by at most the tolerance.
class Door {
 public:
  Door(double tolerance, CurvePoints& out) : tolerance_(tolerance), out_(out) {}

  void add(double x, double y) {
    if (out_.x.empty()) return keep(x, y);
    if (waiting_ && !suits(x, y)) {
      keep(x_, y_);
      waiting_ = false;
    }
    const double dx = x - out_.x.back(), dy = y - out_.y.back();
    if (!waiting_) least_ = -std::numeric_limits<double>::infinity(), most_ = -least_;
    if (dx > 0) {
      least_ = std::max(least_, (dy - tolerance_) / dx), most_ = std::min(most_, (dy + tolerance_) / dx);
    } else if (std::abs(dy) > tolerance_) {
      least_ = std::numeric_limits<double>::infinity(), most_ = -least_;  // a vertical piece has no slope
    }
    x_ = x, y_ = y;
    waiting_ = true;
  }
  void finish() {
    if (waiting_) keep(x_, y_);
  }

 private:
  /// Returns true if the line to this point represents all points since the last retained one.
  [[nodiscard]] bool suits(double x, double y) const {
    const double dx = x - out_.x.back();
    if (!(dx > 0) || x == x_) return false;  // both ends of a vertical piece are retained
    const double slope = (y - out_.y.back()) / dx;
    return slope >= least_ && slope <= most_;
  }
  void keep(double x, double y) {
    out_.x.push_back(x);
    out_.y.push_back(y);
  }

  double tolerance_;
  CurvePoints& out_;
  bool waiting_ = false;
  double x_ = 0, y_ = 0, least_ = 0, most_ = 0;
};

}  // namespace

void thin_curve(std::span<const double> x, std::span<const double> y, double column, double tolerance,
                CurvePoints& out) {
  out.x.clear();
  out.y.clear();
  Door door(tolerance, out);
  const std::size_t n = std::min(x.size(), y.size());
  for (std::size_t first = 0; first < n;) {
    const double end = x.front() + column * (std::floor((x[first] - x.front()) / column) + 1);
    std::size_t last = first, low = first, high = first;
    for (std::size_t i = first; i < n && (i == first || x[i] < end); last = i++) {
      if (y[i] < y[low]) low = i;
      if (y[i] > y[high]) high = i;
    }
    std::array<std::size_t, 4> points{first, low, high, last};
    std::sort(points.begin(), points.end());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i == 0 || points[i] != points[i - 1]) door.add(x[points[i]], y[points[i]]);
    first = last + 1;
  }
  door.finish();
}

CurvePoints thin_path(std::span<const double> x, std::span<const double> y, double column, double tolerance) {
  CurvePoints path, part;
  const std::size_t n = std::min(x.size(), y.size());
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first + 1;
    while (end < n && x[end] == x[first]) ++end;  // the direction is that of the first change
    const double sign = end < n && x[end] < x[first] ? -1 : 1;
    while (end < n && sign * x[end] >= sign * x[end - 1]) ++end;
    if (sign > 0) {
      thin_curve(x.subspan(first, end - first), y.subspan(first, end - first), column, tolerance, part);
    } else {
      std::vector<double> mirrored(x.begin() + static_cast<std::ptrdiff_t>(first),
                                   x.begin() + static_cast<std::ptrdiff_t>(end));
      for (double& value : mirrored) value = -value;
      thin_curve(mirrored, y.subspan(first, end - first), column, tolerance, part);
      for (double& value : part.x) value = -value;
    }
    path.x.insert(path.x.end(), part.x.begin(), part.x.end());
    path.y.insert(path.y.end(), part.y.begin(), part.y.end());
    first = end;
  }
  return path;
}

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
