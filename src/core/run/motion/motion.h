// The motion of a scenario: the pose of the mocap body in each step, and the steps that are recorded. Each kind has a
// source of its own with its lead_finger(); the parts of kinds that others use are at the end.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A motion without state: it gives the pose of any step at any time.
struct Motion {
  Pose X_start;  ///< pose of the finger's mesh-file frame before the first step, world
  /// X_WM of the mocap body in a step. Empty if nothing leads the finger (a drop).
  std::function<Pose(std::uint64_t)> pose;
  /// Travel in a recording [m]. If empty, the travel is the distance of the mocap body from its start.
  std::function<double(std::uint64_t)> travel;
  double timestep = 0;  ///< [s]
  double steps_per_row = 1;
  std::uint64_t last_step = 0;
  dvec3 lead_M{0};                   ///< lead_point() at the start; its path is drawn
  std::vector<WayPoint> way_points;  ///< ends of the parts; a path through them is similar

  /// Returns the number of rows up to and including this step, minus one.
  [[nodiscard]] double rows(std::uint64_t step) const;
  [[nodiscard]] bool row_due(std::uint64_t step) const;
};

/// Returns R_WM with `distal` forward (+x) and below the horizontal by the tilt, and `pad` down and back.
dquat finger_orientation(const SensorFrame& frame, double tilt_deg);

/// Returns the vertex that is lowest in the world, frame M.
dvec3 lowest_vertex(const TriMesh& skin, const Pose& X_WM);

/// Returns the point of the finger in the middle of its width, with the world x and z of its lowest vertex, frame M.
dvec3 lead_point(const TriMesh& skin, const Pose& X_WM);

/// Returns the pose X_WM with the orientation `q_WM` at which lead_point() is at `place`.
Pose place_finger(const TriMesh& skin, const dquat& q_WM, const dvec3& place);

/// Returns the distances of the lowest point of a finger at `X_WM` from an upright edge, before and past the edge along
/// +x, at which the whole finger is clear of the object [m]. The edge is the line x = 0 at height `crest`. The object
/// is below the two planes that descend from the edge by 45 degrees, each raised by at most `round`.
dvec2 clear_reach(const TriMesh& skin, const Pose& X_WM, double crest, double round);

/// Returns the motion of a scenario. `object` is the bounds of the object in the world. Throws Error for a recording
/// that is not readable or has no poses, and for a scenario with too many steps.
Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object);

/// The values from which a motion is built. Borrows all of them.
struct MotionInput {
  const TriMesh& skin;  ///< the finger, in the frame of its mesh file
  const SensorFrame& frame;
  const Scenario& scenario;
  const Aabb& object;  ///< bounds of the object in the world
};

// Each sets all members of the motion except `timestep` and `lead_M`. `motion.timestep` is that of the scenario before
// the call. Throws Error if the scenario takes too many steps.
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Sweep& sweep);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Press& press);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Roll& roll);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Twist& twist);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Slide& slide);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Drop& drop);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Path& path);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Replay& replay);
void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Paper& paper);

inline constexpr double kRadiansPerDegree = kPi / 180.0;

/// A part of a motion.
struct MotionPart {
  double seconds = 0;                ///< duration [s]
  std::function<Pose(double)> pose;  ///< X_WM at a fraction of the duration, 0 to 1
};

/// Returns the part at the depth of a pressed motion: from the pose X_WM at the depth and the lowest point p_W there.
using PartAtDepth = std::function<MotionPart(const Pose& X_down, const dvec3& lowest_W)>;

/// Leads the finger down, through the part at the depth, and the same way back.
void lead_pressed(Motion& motion, const MotionInput& input, const scenarios::Pressed& pressed, const PartAtDepth& part);

/// Ends the motion after `seconds`, with a row per `record_interval` [s].
void end_after(Motion& motion, double record_interval, double seconds);

/// Adds the pose of a step as a waypoint.
void add_way_point(Motion& motion, std::uint64_t step);

/// Returns the number of steps, rounded up. Throws Error if the number exceeds the limit of a run.
std::uint64_t last_step_of(double steps);

/// Returns `x`, or the nearest whole number if `x` differs from it by rounding only.
double without_rounding(double x);

// The object of the paper's sweep: a box balanced on one of its edges.

/// Returns the height of the sharp edge, the intersection of the two upper sides, above the rounded edge [m].
double height_of_round(double radius);

/// Returns a box of edge length `size`, balanced on one edge, as a closed mesh. The opposite edge is on top, parallel
/// to y, and rounded by `radius`; the lower edge is the line x = 0, z = 0; y is between -size/2 and size/2. The flat
/// strips that replace the round lie partly inside and partly outside of it: their mean distance from its axis is
/// `radius`, and they deviate from it by at most 2e-3 radius. Requires 0 < radius < size/2.
TriMesh make_upright_edge(double size, double radius);

/// The outline of a body that rolls on a plane without slipping, in the view along y: the convex hull of its vertices
/// in x and z. While the body turns about y by an angle (positive: towards +x) on a plane below it, a vertex of the
/// outline rests on the plane until the next edge is in the plane. The contact travels the length of the outline that
/// has rolled off: R times the angle for a circle.
class RollingOutline {
 public:
  /// `q_WM` is the orientation of the body at angle 0. Requires at least one vertex.
  RollingOutline(const TriMesh& body, const dquat& q_WM);
  struct Contact {
    dvec2 vertex{0};       ///< x and z, at angle 0, of the vertex that rests on the plane [m]
    double travelled = 0;  ///< travel of the contact along x since angle 0 [m]
  };
  /// Returns the contact at an angle [rad].
  [[nodiscard]] Contact at(double angle) const;

 private:
  std::vector<dvec2> hull_;  ///< counter-clockwise from x to z, from the lowest vertex
};

// The demo that the authors of the paper released: the path of the finger onto a box and back.
//
// World of the demo: the box is at (0.01, 0, 0.013) with half edges of 0.025; no gravity. With s = pi t / 25 s, t from
// 0 to 25 s, the mocap body is at
//
//   x = -0.020 + 0.025 sin s,  y = 0,  z = 0.070 - 0.012 sin s,  q = (0.271 0.653 0.653 0.271) normalised:
//
// a straight line there and back. The demo moves the mocap body 1000 times along this path; here it moves in every
// step. The demo uses MuJoCo's default weld (solref 0.02 1) and density (a finger of 5 g): the finger yields until it
// presses with 0.03 N, and readings jump by a third of a peak. Here the weld is that of all other scenarios: the finger
// presses with 0.9 N, and readings are those of the paper.

inline constexpr double kDemoSeconds = 25;
inline constexpr double kPaperFriction = 0.3;

/// Returns R_WM; M is the frame of the finger's mesh file. The orientation of the paper's finger is the quaternion
/// above. Any other finger is turned until its `distal` and `pad` are parallel to those of the paper's finger.
dquat demo_orientation(const SensorFrame& frame);

/// Returns the lowest point in the middle of the finger's width at `time` [s], frame W. The mesh file of the paper's
/// finger is then at the pose above. All fingers have the same path and the same depth: 3.4 mm.
dvec3 demo_lead(double time);

/// Returns the length of the path up to `time` [m].
double demo_travel(double time);

}  // namespace taxel
