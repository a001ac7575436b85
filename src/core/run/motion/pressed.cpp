#include "core/run/motion/kinds.h"

namespace taxel {

void lead_pressed(Motion& motion, const MotionInput& input, const scenarios::Pressed& pressed,
                  const PartAtDepth& part_at_depth) {
  const dvec3 touch(input.object.center().x + pressed.place, 0, input.object.hi.z);
  const double drop = pressed.clearance + pressed.depth;
  motion.X_start = place_finger(input.skin, finger_orientation(input.frame, pressed.tilt_deg),
                                touch + dvec3(0, 0, pressed.clearance));
  const auto lowered = [X = motion.X_start, drop](double u) { return Pose{X.q, X.p - dvec3(0, 0, u * drop)}; };
  const dvec3 lowest_W = motion.X_start * lowest_vertex(input.skin, motion.X_start) - dvec3(0, 0, drop);
  const MotionPart at_depth = part_at_depth(lowered(1), lowest_W);
  std::vector<MotionPart> parts{{drop / pressed.speed, lowered},
                                at_depth,
                                {pressed.hold, [at_depth](double) { return at_depth.pose(1); }},
                                {at_depth.seconds, [at_depth](double u) { return at_depth.pose(1 - u); }},
                                {drop / pressed.speed, [lowered](double u) { return lowered(1 - u); }}};
  std::erase_if(parts, [](const MotionPart& part) { return !(part.seconds > 0); });
  double end = 0;
  motion.way_points.push_back({0, motion.X_start});
  for (const MotionPart& part : parts) motion.way_points.push_back({end += part.seconds, part.pose(1)});
  end_after(motion, pressed.record_interval, end);
  motion.pose = [parts, timestep = motion.timestep](std::uint64_t step) {
    double t = static_cast<double>(step) * timestep;
    for (const MotionPart& part : parts) {
      if (t < part.seconds) return part.pose(t / part.seconds);
      t -= part.seconds;
    }
    return parts.back().pose(1);
  };
}

}  // namespace taxel
