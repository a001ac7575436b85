#include "core/document/scenario/path.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/document/paper_setting.h"
#include "core/document/scenario/kinds.h"

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

namespace taxel {
namespace {

/// Returns the slope at the middle of three points from the slopes s0, s1 of the secants over h0, h1: the weighted
/// harmonic mean if both have the same sign, otherwise 0 (Fritsch and Butland 1984, equation 5, weights of Brodlie).
double monotone_slope(double h0, double h1, double s0, double s1) {
  if (!(s0 * s1 > 0)) return 0;
  const double a = (h0 + 2 * h1) / (3 * (h0 + h1));
  return s0 * s1 / (a * s1 + (1 - a) * s0);
}

/// Returns the cubic through (0, y0) and (h, y1) with slopes d0, d1 (Hermite).
double hermite(double t, double h, double y0, double y1, double d0, double d1) {
  const double u = t / h, v = 1 - u;
  return y0 + (y1 - y0) * u * u * (3 - 2 * u) + h * u * v * (d0 * v - d1 * u);
}

/// Returns the smaller of the two angles between two orientations [radians].
double angle_between(const dquat& a, const dquat& b) {
  const dquat d = glm::conjugate(a) * b;
  return 2 * std::atan2(glm::length(dvec3(d.x, d.y, d.z)), std::abs(d.w));
}

}  // namespace

PathCurve::PathCurve(std::vector<WayPoint> points)
    : points_(std::move(points)),
      turned_(points_.size(), 0.0),
      velocity_(points_.size(), dvec3(0)),
      turning_(points_.size(), 0.0) {
  for (WayPoint& point : points_) point.X_WM.q = glm::normalize(point.X_WM.q);
  for (std::size_t i = 1; i < points_.size(); ++i)
    turned_[i] = turned_[i - 1] + angle_between(points_[i - 1].X_WM.q, points_[i].X_WM.q);
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const double h0 = points_[i].time - points_[i - 1].time, h1 = points_[i + 1].time - points_[i].time;
    const dvec3 s0 = (points_[i].X_WM.p - points_[i - 1].X_WM.p) / h0;
    const dvec3 s1 = (points_[i + 1].X_WM.p - points_[i].X_WM.p) / h1;
    for (int k = 0; k < 3; ++k) velocity_[i][k] = monotone_slope(h0, h1, s0[k], s1[k]);
    turning_[i] = monotone_slope(h0, h1, (turned_[i] - turned_[i - 1]) / h0, (turned_[i + 1] - turned_[i]) / h1);
  }
}

Pose PathCurve::at(double time) const {
  if (!(time > begin())) return points_.front().X_WM;
  if (!(time < end())) return points_.back().X_WM;
  std::size_t i = 0;
  while (points_[i + 1].time <= time) ++i;
  const WayPoint &a = points_[i], &b = points_[i + 1];
  const double t = time - a.time, h = b.time - a.time;
  Pose X;
  for (int k = 0; k < 3; ++k) X.p[k] = hermite(t, h, a.X_WM.p[k], b.X_WM.p[k], velocity_[i][k], velocity_[i + 1][k]);
  const double whole = turned_[i + 1] - turned_[i];
  const double part = whole > 0 ? hermite(t, h, 0, whole, turning_[i], turning_[i + 1]) / whole : 0;
  X.q = glm::normalize(glm::slerp(a.X_WM.q, b.X_WM.q, part));
  return X;
}

Scenario path_of_run(Scenario edited, const Scenario& run, std::vector<WayPoint> points) {
  const bool keeps_object = has_object(edited);
  edited = with_kind(edited, kKind<scenarios::Path>);
  if (!keeps_object) {
    edited.shape = run.shape;
    edited.object = run.object;
    edited.box_size = run.box_size;
    edited.edge_radius = run.edge_radius;
  }
  if (run.is<scenarios::Paper>()) {
    edited.shape = ObjectShape::box;
    edited.object.clear();
    edited.box_size = kDemoBox.extent().x;
    const dvec3 to_other_boxes(-kDemoBox.lo.x, -kDemoBox.center().y, -kDemoBox.lo.z);
    for (WayPoint& point : points) point.X_WM.p += to_other_boxes;
  }
  edited.as<scenarios::Path>().points = std::move(points);
  return edited;
}

}  // namespace taxel
