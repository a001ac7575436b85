#include <cmath>

#include "core/run/motion/motion.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Twist& twist) {
  lead_pressed(motion, input, twist, [&](const Pose& X_down, const dvec3& lowest_W) {
    const double turn = twist.angle_deg * kRadiansPerDegree;
    const dvec3 axis = glm::normalize(X_down.rotate(input.frame.pad));
    return MotionPart{std::abs(twist.angle_deg) / twist.rate_deg, [=](double u) {
                        const dquat q = glm::angleAxis(u * turn, axis);
                        return Pose{q * X_down.q, lowest_W + q * (X_down.p - lowest_W)};
                      }};
  });
}

}  // namespace taxel
