#include "core/run/motion/motion.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Press& press) {
  lead_pressed(motion, input, press, [](const Pose& X_down, const dvec3&) {
    return MotionPart{0, [X_down](double) { return X_down; }};
  });
}

}  // namespace taxel
