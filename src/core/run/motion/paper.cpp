#include "core/run/motion/motion.h"

namespace taxel {
namespace {

const dvec3 kFrom{-0.020, 0, 0.070}, kSpan{0.025, 0, -0.012};  // start and extent of the path [m]
const dquat kDemoTurn = glm::normalize(dquat(0.271, 0.653, 0.653, 0.271));
const SensorFrame kPaperFrame{{0, 0, 1}, {0, -1, 0}};

/// Offset of the lowest point, in the middle of the width of the paper's finger, from the origin of its mesh file in
/// the orientation of the demo; world axes [m]. Computed from the vertices of the released file ubi_tip_collision.stl.
const dvec3 kPaperLead{0.019550891655317794, 1.6479969024658057e-05, -0.023408118042095406};

double phase(double time) {
  return std::sin(kPi * std::clamp(time / kDemoSeconds, 0.0, 1.0));
}

/// Returns the rotation from the frame of a mesh file to the axes (distal, pad, width).
dmat3 finger_axes(const SensorFrame& frame) {
  const dvec3 distal = glm::normalize(frame.distal);
  const dvec3 pad = glm::normalize(frame.pad - glm::dot(frame.pad, distal) * distal);
  return glm::transpose(dmat3(distal, pad, glm::cross(distal, pad)));
}

}  // namespace

dquat demo_orientation(const SensorFrame& frame) {
  const dmat3 R_PM = glm::transpose(finger_axes(kPaperFrame)) * finger_axes(frame);
  return glm::normalize(kDemoTurn * glm::quat_cast(R_PM));
}

dvec3 demo_lead(double time) {
  return kFrom + kPaperLead + phase(time) * kSpan;
}

double demo_travel(double time) {
  const double way = glm::length(kSpan), s = phase(time);
  return time <= 0.5 * kDemoSeconds ? way * s : way * (2 - s);
}

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
