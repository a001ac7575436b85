#include <cmath>

#include "core/run/motion/motion.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Slide& slide) {
  lead_pressed(motion, input, slide, [&](const Pose& X_down, const dvec3&) {
    const double direction = slide.direction_deg * kRadiansPerDegree;
    const dvec3 offset = slide.distance * dvec3(std::cos(direction), std::sin(direction), 0);
    return MotionPart{slide.distance / slide.speed, [=](double u) { return Pose{X_down.q, X_down.p + u * offset}; }};
  });
}

}  // namespace taxel
