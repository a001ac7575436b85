#include "core/run/motion/kinds.h"
#include "core/run/motion/paper_demo.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Paper& paper) {
  motion.X_start = place_finger(input.skin, demo_orientation(input.frame), demo_lead(0));
  end_after(motion, paper.record_interval, kDemoSeconds);
  motion.travel = [timestep = motion.timestep](std::uint64_t step) {
    return demo_travel(static_cast<double>(step) * timestep);
  };
  motion.pose = [X = motion.X_start, timestep = motion.timestep](std::uint64_t step) {
    return Pose{X.q, X.p + (demo_lead(static_cast<double>(step) * timestep) - demo_lead(0))};
  };
  for (const std::uint64_t step : {std::uint64_t{0}, motion.last_step / 2, motion.last_step})
    add_way_point(motion, step);
}

}  // namespace taxel
