// The roll: the pressed finger rolls about its width axis without slipping, and back.
#pragma once

#include "core/document/scenario/kinds/pressed.h"

namespace taxel::scenarios {

struct Roll : Pressed {
  static constexpr std::string_view kWord = "roll";
  double angle_deg = 30.0;  ///< angle of the roll; positive towards +x
  double rate_deg = 60.0;   ///< angular speed [degrees/s]

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(kAngle, self.angle_deg);
    v(kRate, self.rate_deg);
  }
  bool operator==(const Roll&) const = default;
};

}  // namespace taxel::scenarios
