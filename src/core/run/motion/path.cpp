#include "core/document/scenario/path.h"
#include "core/run/motion/motion.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput&, const scenarios::Path& path) {
  const PathCurve curve(path.points);
  motion.X_start = curve.at(0);
  motion.way_points = path.points;
  end_after(motion, path.record_interval, curve.end());
  motion.pose = [curve, timestep = motion.timestep](std::uint64_t step) {
    return curve.at(static_cast<double>(step) * timestep);
  };
}

}  // namespace taxel
