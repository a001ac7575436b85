// The motion of the finger in each scenario kind: one overload of lead_finger() per kind, each in a file of its own.
#pragma once

#include <functional>

#include "core/document/scenario/scenario.h"
#include "core/run/motion/motion.h"

namespace taxel {

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

}  // namespace taxel
