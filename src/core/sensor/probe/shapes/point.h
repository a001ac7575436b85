// A probe with the shape of a cone.
#pragma once

#include "core/sensor/probe/shapes/probe_form.h"

namespace taxel {

/// A cone with its apex as the tip. Its volume up to any height is that of the round cone.
struct ProbePoint {
  static constexpr const char *kWord = "point", *kLabel = "Point";
  static constexpr bool kIsRound = true;  ///< a turn about z changes nothing
  static constexpr FieldKind kField = FieldKind::pad;
  double height = 0.02;   ///< [m]
  double angle_deg = 60;  ///< full opening angle

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"height", "Height", "", FieldQuantity::length, FieldRange::positive}, height);
    v(FieldSpec{"angle_deg", "Angle", "", FieldQuantity::angle, FieldRange::positive}, angle_deg);
  }
  /// Reduces the size to that of a probe with this radius [m].
  void shrink_to(double radius) { height = std::min(height, 4 * radius); }
  /// Throws Error if a value is out of range.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbePoint&) const = default;
};

}  // namespace taxel
