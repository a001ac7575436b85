// The part of the section that the section panel shows.
#pragma once

#include "core/base/math.h"

namespace taxel::ui {

struct SectionState {
  double zoom = 1;       ///< 1 if the sensor, the contact or the taxel of the section fits the panel
  dvec2 pan{0};          ///< vector from the section's focus to the middle of the panel [m]
  double slab = 0.0002;  ///< distance from the plane within which rays and samples are drawn [m]
};

}  // namespace taxel::ui
