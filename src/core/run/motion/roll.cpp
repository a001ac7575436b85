#include <cmath>
#include <memory>

#include "core/run/motion/kinds.h"
#include "core/run/motion/rolling_outline.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Roll& roll) {
  lead_pressed(motion, input, roll, [&](const Pose& X_down, const dvec3& lowest_W) {
    const double turn = roll.angle_deg * kRadiansPerDegree;
    const auto outline = std::make_shared<const RollingOutline>(input.skin, X_down.q);
    return MotionPart{std::abs(roll.angle_deg) / roll.rate_deg, [=](double u) {
                        const RollingOutline::Contact contact = outline->at(u * turn);
                        const dquat q = glm::angleAxis(u * turn, dvec3(0, 1, 0));
                        const dvec3 contact_W(lowest_W.x + contact.travelled, X_down.p.y, lowest_W.z);
                        return Pose{q * X_down.q, contact_W - q * dvec3(contact.vertex.x, 0, contact.vertex.y)};
                      }};
  });
}

}  // namespace taxel
