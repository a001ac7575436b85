// The sweep of a finger over the upright edge of a box, as in the paper, and the mesh of this object.
//
// The round of the edge is an arc between the two upper sides, which are its tangents. It is replaced by a polygon of
// 12 sides whose mean distance from the axis is the radius. So the sides lie partly inside and partly outside of the
// round, and errors cancel that chords, which are all inside, would add up.
//
// A sweep begins and ends clear of the object: the distance follows from the skin's foremost and hindmost points below
// the edge's top, the depth, the height of the round and a gap of 1 mm. The finger moves a fixed distance per step, so
// each row is the same step of every run. Theory: docs/theory/run.md, "The clear distance of the sweep".
#include "core/run/motion/motion.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

/// Number of sides of the polygon that replaces the arc, with the two upper sides of the box, which are tangents of it.
/// With 12 sides readings of the sweep are nearer to those of 256 sides than with 32 chords of the arc, and take half
/// the time.
constexpr int kArcSides = 12;

/// The line dot(normal, x) = distance.
struct Side {
  dvec2 normal{0};
  double distance = 0;
};

dvec2 intersection(const Side& a, const Side& b) {
  const double det = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  return dvec2(a.distance * b.normal.y - b.distance * a.normal.y, a.normal.x * b.distance - b.normal.x * a.distance) /
         det;
}

/// Returns a side of the round, about the arc's centre. Sides turn by delta. A point of one at the angle phi from its
/// middle is d / cos(phi) from the centre, in the mean d (1 + delta^2 / 24): the distance d makes this the radius.
Side arc_side(int i, double radius) {
  const double delta = kPi / 2 / kArcSides, angle = kPi / 4 + delta * i;
  const bool is_upper_side = i == 0 || i == kArcSides;
  return {{std::cos(angle), std::sin(angle)}, is_upper_side ? radius : radius * (1 - delta * delta / 24)};
}

// Section of the mesh at right angles to y:
//
//             __          arc of 90 degrees between the two upper sides: its centre is `radius` sqrt(2) below the
//           /    \        sharp edge, because the sides descend by 45 degrees
//         /        \      .
//         \        /      .
//           \    /        .
//             \/          z = 0

/// Returns the corners (x, z) of the section, counter-clockwise from x to z, from the lower edge.
std::vector<dvec2> section(double size, double radius) {
  const double half = size * std::sqrt(0.5);  // half of the diagonal
  const dvec2 center(0, 2 * half - std::sqrt(2.0) * radius);
  std::vector<dvec2> corners{{0, 0}, {half, half}};
  for (int i = 0; i < kArcSides; ++i)
    corners.push_back(center + intersection(arc_side(i, radius), arc_side(i + 1, radius)));
  corners.emplace_back(-half, half);
  return corners;
}

}  // namespace

double height_of_round(double radius) {
  return (std::sqrt(2.0) - 1) * radius;
}

TriMesh make_upright_edge(double size, double radius) {
  const std::vector<dvec2> corners = section(size, radius);
  const int n = static_cast<int>(corners.size());
  std::vector<dvec3> vertices;
  for (const dvec2& corner : corners)
    for (const double y : {-0.5 * size, 0.5 * size}) vertices.emplace_back(corner.x, y, corner.y);
  std::vector<ivec3> faces;
  for (int i = 0; i < n; ++i) {  // vertex 2 i has the smaller y, vertex 2 i + 1 the larger
    const int j = (i + 1) % n;
    faces.emplace_back(2 * i, 2 * i + 1, 2 * j + 1);
    faces.emplace_back(2 * i, 2 * j + 1, 2 * j);
  }
  for (int i = 1; i + 1 < n; ++i) {  // both ends are fans about the lower edge: the section is convex
    faces.emplace_back(0, 2 * i, 2 * (i + 1));
    faces.emplace_back(1, 2 * (i + 1) + 1, 2 * i + 1);
  }
  return TriMesh(std::move(vertices), std::move(faces));
}

namespace {

/// Smallest gap between the finger and an upright edge at the start and at the end of a sweep [m]. The lag of the
/// finger behind the mocap body is much smaller, so all readings begin and end at 0.
constexpr double kEdgeGap = 0.001;

/// Returns the distances of the lowest point from the edge at the start and at the end [m].
dvec2 sweep_reach(const MotionInput& input, const scenarios::Sweep& sweep) {
  const dvec2 requested(sweep.before, sweep.past);
  if (input.scenario.shape != ObjectShape::edge) return requested;
  const Pose X = place_finger(input.skin, finger_orientation(input.frame, sweep.tilt_deg), dvec3(0));
  const double round = height_of_round(input.scenario.edge_radius);
  return glm::max(requested, clear_reach(input.skin, X, sweep.depth, round) + kEdgeGap);
}

}  // namespace

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Sweep& sweep) {
  const double steps_per_metre = without_rounding(1.0 / (sweep.speed * motion.timestep));
  const dvec2 reach = sweep_reach(input, sweep);
  const double distance = reach[0] + reach[1];
  motion.X_start = place_finger(input.skin, finger_orientation(input.frame, sweep.tilt_deg),
                                {-reach[0], 0, input.object.hi.z - sweep.depth});
  motion.steps_per_row = without_rounding(sweep.record_every * steps_per_metre);
  motion.last_step = last_step_of(distance * steps_per_metre);
  motion.travel = [distance, steps_per_metre](std::uint64_t step) {
    return std::min(distance, static_cast<double>(step) / steps_per_metre);
  };
  motion.pose = [X = motion.X_start, travel = motion.travel](std::uint64_t step) {
    return Pose{X.q, X.p + travel(step) * dvec3(1, 0, 0)};
  };
  add_way_point(motion, 0);
  add_way_point(motion, motion.last_step);
}

}  // namespace taxel
