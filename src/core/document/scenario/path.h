// Paths of a scenario: the curve of a body through waypoints, and the path that a recorded run becomes.
#pragma once

#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// A curve that passes every waypoint at its time, with continuous velocity, and is at rest at both ends.
///
/// Each coordinate of the position is the monotone piecewise cubic of Fritsch and Butland, "A method for constructing
/// local monotone piecewise cubic interpolants" (SIAM J. Sci. Stat. Comput. 5, 1984): between two waypoints its values
/// are between those at the waypoints. A spline with continuous acceleration would overshoot, and press deeper than all
/// waypoints. Between two waypoints the orientation turns about one axis (Shoemake's slerp, SIGGRAPH 1985) by an angle
/// that is such a cubic of the time. The angular speed is therefore continuous; the axis is not.
class PathCurve {
 public:
  /// Requires at least one waypoint, and ascending times.
  explicit PathCurve(std::vector<WayPoint> points);
  /// Returns the pose at a time. Before the first waypoint it is the first pose, after the last one the last pose.
  [[nodiscard]] Pose at(double time) const;
  [[nodiscard]] double begin() const { return points_.front().time; }
  [[nodiscard]] double end() const { return points_.back().time; }

 private:
  std::vector<WayPoint> points_;
  std::vector<double> turned_;   ///< angle turned up to each waypoint
  std::vector<dvec3> velocity_;  ///< velocity at each waypoint
  std::vector<double> turning_;  ///< angular speed at each waypoint
};

/// Returns `edited` as a path through `points`, poses in the world of a run of the scenario `run`. The object is that
/// of `edited`, or that of the run if `edited` has none because it is the paper's demo. The box of the demo (kDemoBox)
/// is at another place than the boxes of other kinds, so the points of a run of the demo move together with the box:
/// the finger touches the box at the same points.
Scenario path_of_run(Scenario edited, const Scenario& run, std::vector<WayPoint> points);

}  // namespace taxel
