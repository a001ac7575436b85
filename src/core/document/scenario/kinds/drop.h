// The drop: the finger falls on the object under gravity; no weld holds it.
#pragma once

#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel::scenarios {

struct Drop : Timed {
  static constexpr std::string_view kWord = "drop";
  double tilt_deg = 45.0;  ///< angle of `distal` below the horizontal
  double place = 0.0;      ///< x of the lowest point, from the object's middle [m]
  double height = 0.010;   ///< gap between finger and object at the start [m]
  double duration = 0.5;   ///< duration of the scenario [s]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(kTilt, self.tilt_deg);
    v(kPlace, self.place);
    v(FieldSpec{"height", "Height", "From which it drops: the gap to the object", FieldQuantity::length,
                FieldRange::positive},
      self.height);
    v(FieldSpec{"duration", "Drop lasts", "Until the scenario is over", FieldQuantity::duration, FieldRange::positive},
      self.duration);
  }
  bool operator==(const Drop&) const = default;
};

}  // namespace taxel::scenarios
