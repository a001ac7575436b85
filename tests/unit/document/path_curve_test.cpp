// A path passes its waypoints, never leaves the range between them, and moves and rotates without jumps.
#include "core/document/scenario/path.h"

#include <gtest/gtest.h>

namespace taxel {
namespace {

dquat about(const dvec3& axis, double degrees) {
  return glm::angleAxis(degrees * kPi / 180, axis);
}

/// Returns a path that goes down, rests, moves along with a rotation by 90 degrees and then by 60 degrees, and goes up.
std::vector<WayPoint> press_and_turn() {
  const dvec3 y(0, 1, 0);
  return {{0.1, {about(y, 0), {0, 0, 0.01}}},           {0.3, {about(y, 0), {0, 0, 0.002}}},
          {0.4, {about(y, 0), {0, 0, 0.002}}},          {0.9, {about(y, 90), {0.02, -0.01, 0.002}}},
          {1.0, {about(y, 150), {0.03, -0.01, 0.004}}}, {1.5, {about(y, 150), {0.03, 0, 0.02}}}};
}

double angle_between(const dquat& a, const dquat& b) {
  return 2 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

TEST(PathCurve, PassesItsWaypoints) {
  const PathCurve curve(press_and_turn());
  EXPECT_EQ(curve.begin(), 0.1);
  EXPECT_EQ(curve.end(), 1.5);
  for (const WayPoint& point : press_and_turn()) {
    const Pose X = curve.at(point.time);
    EXPECT_LT(glm::distance(X.p, point.X_WM.p), 1e-16) << point.time;
    EXPECT_LT(angle_between(X.q, point.X_WM.q), 1e-7) << point.time;
  }
  EXPECT_EQ(curve.at(-1).p, curve.at(0.1).p);
  EXPECT_EQ(curve.at(9).p, curve.at(1.5).p);
}

TEST(PathCurve, NeverLeavesTheRangeBetweenTwoWaypoints) {
  const std::vector<WayPoint> points = press_and_turn();
  const PathCurve curve(points);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const dvec3 lo = glm::min(points[i - 1].X_WM.p, points[i].X_WM.p),
                hi = glm::max(points[i - 1].X_WM.p, points[i].X_WM.p);
    for (double u = 0; u <= 1; u += 0.01) {
      const dvec3 p = curve.at(points[i - 1].time + u * (points[i].time - points[i - 1].time)).p;
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(p[k], lo[k] - 1e-17);
        EXPECT_LE(p[k], hi[k] + 1e-17);
      }
    }
  }
  EXPECT_EQ(curve.at(0.35).p, dvec3(0, 0, 0.002));  // constant during a rest
}

TEST(PathCurve, HasNoJumpsInVelocityAndAngularSpeed) {
  const PathCurve curve(press_and_turn());
  constexpr double h = 1e-5;
  dvec3 velocity(0);
  double turning = 0;
  for (double t = 0.05; t < 1.6; t += h) {
    const Pose a = curve.at(t), b = curve.at(t + h);
    const dvec3 v = (b.p - a.p) / h;
    const double w =
        2 *
        std::asin(std::min(1.0, glm::length(dvec3(b.q.x, b.q.y, b.q.z) * a.q.w - dvec3(a.q.x, a.q.y, a.q.z) * b.q.w))) /
        h;
    EXPECT_LT(glm::distance(v, velocity), 1e-3) << t;  // compared with 0.15 m/s
    EXPECT_LT(std::abs(w - turning), 0.05) << t;       // compared with 10 rad/s
    velocity = v, turning = w;
  }
}

TEST(PathCurve, IsStraightForAStraightUniformMotion) {
  std::vector<WayPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({0.1 * i, {about({0, 0, 1}, 20 * i), dvec3(1, 2, 3) * (0.001 * i)}});
  const PathCurve curve(points);
  for (double t = 0.1; t <= 0.3; t += 0.005) {  // the motion starts and stops at the ends
    EXPECT_LT(glm::distance(curve.at(t).p, dvec3(1, 2, 3) * (0.01 * t)), 1e-15);
    EXPECT_LT(angle_between(curve.at(t).q, about({0, 0, 1}, 200 * t)), 1e-7);
  }
}

}  // namespace
}  // namespace taxel
