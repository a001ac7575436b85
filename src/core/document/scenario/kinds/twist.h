// The twist: the pressed finger turns about its pad's normal through its lowest point, and back.
#pragma once

#include "core/document/scenario/kinds/pressed.h"

namespace taxel::scenarios {

struct Twist : Pressed {
  static constexpr std::string_view kWord = "twist";
  double angle_deg = 30.0;  ///< angle of the twist
  double rate_deg = 60.0;   ///< angular speed [degrees/s]

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(kAngle, self.angle_deg);
    v(kRate, self.rate_deg);
  }
  bool operator==(const Twist&) const = default;
};

}  // namespace taxel::scenarios
