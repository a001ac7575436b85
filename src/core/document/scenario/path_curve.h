// The way of a body through way points.
#pragma once

#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// Passes every way point at its time, with continuous velocity, at rest at both ends.
///
/// Each coordinate of the position is the monotone piecewise cubic of Fritsch and Butland, "A method for constructing
/// local monotone piecewise cubic interpolants" (SIAM J. Sci. Stat. Comput. 5, 1984): between two way points it never
/// leaves the values at them. A spline with continuous acceleration would overshoot, and press deeper than any way
/// point says. The orientation turns about one axis between two way points (Shoemake's slerp, SIGGRAPH 1985), by an
/// angle that is such a cubic of the time as well, so that the speed of turning is continuous too; its axis is not.
class PathCurve {
 public:
  /// At least one way point, times ascending.
  explicit PathCurve(std::vector<WayPoint> points);
  /// Before the first way point the pose of that one, after the last that of the last.
  [[nodiscard]] Pose at(double time) const;
  [[nodiscard]] double begin() const { return points_.front().time; }
  [[nodiscard]] double end() const { return points_.back().time; }

 private:
  std::vector<WayPoint> points_;
  std::vector<double> turned_;   ///< angle turned up to each way point
  std::vector<dvec3> velocity_;  ///< at each way point
  std::vector<double> turning_;  ///< likewise, of the angle
};

}  // namespace taxel
