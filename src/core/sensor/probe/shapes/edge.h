// A probe with the shape of a wedge.
#pragma once

#include "core/sensor/probe/shapes/probe_form.h"

namespace taxel {

/// A wedge whose edge is parallel to x, with the tip in the middle of the edge.
struct ProbeEdge {
  static constexpr const char *kWord = "edge", *kLabel = "Edge";
  static constexpr bool kIsRound = false;
  static constexpr FieldKind kField = FieldKind::pad;
  double length = 0.02;   ///< [m]
  double height = 0.02;   ///< [m]
  double angle_deg = 90;  ///< angle between the two faces at the edge

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"length", "Length", "", FieldQuantity::length, FieldRange::positive}, length);
    v(FieldSpec{"angle_deg", "Angle", "", FieldQuantity::angle, FieldRange::positive}, angle_deg);
  }
  /// Reduces the size to that of a probe with this radius [m].
  void shrink_to(double radius) { length = std::min(length, 4 * radius), height = std::min(height, 4 * radius); }
  /// Throws Error if a value is out of range.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeEdge&) const = default;
};

}  // namespace taxel
