// The fields of kinds that press the finger down to a depth, hold it, and lift it.
#pragma once

#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel::scenarios {

/// `visit_at_depth` of a kind visits the fields of its motion at the depth.
struct Pressed : Timed {
  double depth = 0.0015;     ///< depth below first contact with the object's top [m]
  double speed = 0.010;      ///< speed of the mocap body on straight lines [m/s]
  double tilt_deg = 45.0;    ///< angle of `distal` below the horizontal
  double place = 0.0;        ///< x of the lowest point, from the object's middle [m]
  double clearance = 0.001;  ///< gap between finger and object at the start [m]
  double hold = 0.2;         ///< rest at the end of the motion at the depth [s]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(kDepth, self.depth);
    v(kSpeed, self.speed);
    v(kTilt, self.tilt_deg);
    v(kPlace, self.place);
    v(FieldSpec{"clearance", "Clearance", "Gap between finger and object at the start", FieldQuantity::length,
                FieldRange::not_negative},
      self.clearance);
    Self::visit_at_depth(self, v);
    v(FieldSpec{"hold", "Hold", "Rest at the depth, or at the end of the way there", FieldQuantity::duration,
                FieldRange::not_negative},
      self.hold);
  }
  bool operator==(const Pressed&) const = default;
};

}  // namespace taxel::scenarios
