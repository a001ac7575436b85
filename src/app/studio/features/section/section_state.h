// The extract of the section that its panel shows.
#pragma once

#include "core/base/math.h"

namespace taxel::ui {

struct SectionState {
  double zoom = 1;       ///< 1 if the section fits the panel
  dvec2 pan{0};          ///< vector from the section's focus to the middle of the panel [m]
  double slab = 0.0002;  ///< rays and samples within this distance of the plane are drawn [m], on either side
};

}  // namespace taxel::ui
