#include "core/run/motion/kinds.h"

#include <cmath>

#include "core/base/limits.h"

namespace taxel {

Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object) {
  Motion motion;
  motion.timestep = scenario.timestep;
  const MotionInput input{skin, frame, scenario, object};
  std::visit([&](const auto& kind) { lead_finger(motion, input, kind); }, scenario.motion);
  motion.lead_M = lead_point(skin, motion.X_start);
  return motion;
}

void end_after(Motion& motion, double record_interval, double seconds) {
  motion.steps_per_row = without_rounding(record_interval / motion.timestep);
  motion.last_step = last_step_of(seconds / motion.timestep);
}

void add_way_point(Motion& motion, std::uint64_t step) {
  motion.way_points.push_back({static_cast<double>(step) * motion.timestep, motion.pose(step)});
}

std::uint64_t last_step_of(double steps) {
  check_steps(steps, "the scenario");
  return static_cast<std::uint64_t>(std::ceil(without_rounding(steps)));
}

double without_rounding(double x) {
  const double nearest = std::round(x);
  return std::abs(x - nearest) <= 1e-9 * nearest ? nearest : x;
}

}  // namespace taxel
