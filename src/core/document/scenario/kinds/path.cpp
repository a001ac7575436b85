#include "core/document/scenario/kinds/path.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"

namespace taxel::scenarios {
namespace {

/// Largest deviation of a quaternion's length from 1. Rounding and typed digits stay below this value.
constexpr double kUnitTolerance = 1e-6;

}  // namespace

void Path::check(ObjectShape) const {
  if (points.size() < 2) throw Error("", "/points", fmt::format("a path needs 2 way points, has {}", points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string at = fmt::format("/points/{}", i);
    const WayPoint& point = points[i];
    if (!std::isfinite(point.time) || point.time < 0)
      throw Error("", at + "/time", fmt::format("must not be negative, is {}", point.time));
    if (i > 0 && !(point.time > points[i - 1].time))
      throw Error(
          "", at + "/time",
          fmt::format("must be later than that of the way point before, {}, is {}", points[i - 1].time, point.time));
    if (!is_finite(point.X_WM.p)) throw Error("", at + "/pos", "must be finite");
    const double length = glm::length(point.X_WM.q);
    if (!(std::abs(length - 1) <= kUnitTolerance))
      throw Error("", at + "/quat", fmt::format("must be of length 1, is of length {}", length));
  }
}

}  // namespace taxel::scenarios
