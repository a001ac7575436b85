// A body that rolls on a plane without slipping: the convex hull of its outline, seen along y.
//
// While the body turns, a corner of the hull rests on the plane until the next edge is in the plane, which is the case
// when the body has turned by the direction of this edge. Then the contact has travelled by the length of the edge. So
// the pose at an angle is the sum of the edges up to it, exactly for the tessellated body, and R times the angle for a
// circle. The hull is that of Andrew (1979), O(n log n). Angles may be negative and larger than a turn.
#include "core/run/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace taxel {
namespace {

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Returns one half of the hull (Andrew 1979) of points that are sorted by x, then z.
template <class Points>
std::vector<dvec2> half_hull(const Points& points) {
  std::vector<dvec2> chain;
  for (const dvec2& p : points) {
    while (chain.size() > 1 && cross(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0) chain.pop_back();
    chain.push_back(p);
  }
  chain.pop_back();  // the other half begins with this point
  return chain;
}

}  // namespace

RollingOutline::RollingOutline(const TriMesh& body, const dquat& q_WM) {
  const dmat3 R = glm::mat3_cast(q_WM);
  std::vector<dvec2> points;
  for (const dvec3& v : body.vertices()) {
    const dvec3 p = R * v;
    points.push_back({p.x, p.z});
  }
  const auto before = [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    hull_ = points;
  } else {
    hull_ = half_hull(points);
    std::reverse(points.begin(), points.end());
    const std::vector<dvec2> upper = half_hull(points);
    hull_.insert(hull_.end(), upper.begin(), upper.end());
  }
  const auto lower = [](const dvec2& a, const dvec2& b) { return a.y < b.y; };
  std::rotate(hull_.begin(), std::min_element(hull_.begin(), hull_.end(), lower), hull_.end());
}

RollingOutline::Contact RollingOutline::at(double angle) const {
  const std::size_t n = hull_.size();
  Contact contact{hull_.front(), 0};
  if (n < 3) return contact;
  // The edge in direction phi is in the plane when the body has turned by phi.
  const double forward = angle < 0 ? -1 : 1;
  const auto turn = [&](std::size_t from, std::size_t to, double before) {
    const dvec2 edge = forward * (hull_[to] - hull_[from]);
    const double phi = std::atan2(edge.y, edge.x);
    return phi + 2 * kPi * std::ceil(forward * (before - phi) / (2 * kPi) - 1e-12) * forward;
  };
  double phi = 0;
  for (std::size_t i = 0;;) {
    const std::size_t next = forward > 0 ? (i + 1) % n : (i + n - 1) % n;
    phi = turn(i, next, phi);
    if (forward * phi > forward * angle) return contact;
    contact.travelled += forward * glm::length(hull_[next] - hull_[i]);
    contact.vertex = hull_[next];
    i = next;
  }
}

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Roll& roll) {
  lead_pressed(motion, input, roll, [&](const Pose& X_down, const dvec3& lowest_W) {
    const double turn = roll.angle_deg * kRadiansPerDegree;
    const auto outline = std::make_shared<const RollingOutline>(input.skin, X_down.q);
    return MotionPart{std::abs(roll.angle_deg) / roll.rate_deg, [=](double u) {
                        const RollingOutline::Contact contact = outline->at(u * turn);
                        const dquat q = glm::angleAxis(u * turn, dvec3(0, 1, 0));
                        const dvec3 contact_W(lowest_W.x + contact.travelled, X_down.p.y, lowest_W.z);
                        return Pose{q * X_down.q, contact_W - q * dvec3(contact.vertex.x, 0, contact.vertex.y)};
                      }};
  });
}

}  // namespace taxel
