// The slide: the pressed finger moves along the object's top, and back.
#pragma once

#include "core/document/scenario/kinds/pressed.h"

namespace taxel::scenarios {

struct Slide : Pressed {
  static constexpr std::string_view kWord = "slide";
  double distance = 0.010;     ///< length of the slide [m]
  double direction_deg = 0.0;  ///< direction of the slide, from +x towards +y

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(FieldSpec{"distance", "Slide distance", "There, and the same way back", FieldQuantity::length,
                FieldRange::positive},
      self.distance);
    v(FieldSpec{"direction_deg", "Direction", "Of the slide, from +x towards +y", FieldQuantity::angle},
      self.direction_deg);
  }
  bool operator==(const Slide&) const = default;
};

}  // namespace taxel::scenarios
