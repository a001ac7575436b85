#include "core/run/motion/motion.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput& input, const scenarios::Drop& drop) {
  motion.X_start = place_finger(input.skin, finger_orientation(input.frame, drop.tilt_deg),
                                {input.object.center().x + drop.place, 0, input.object.hi.z + drop.height});
  end_after(motion, drop.record_interval, drop.duration);
}

}  // namespace taxel
