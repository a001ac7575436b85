#include <algorithm>

#include "core/run/motion/kinds.h"
#include "core/run/motion/upright_edge.h"

namespace taxel {
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
