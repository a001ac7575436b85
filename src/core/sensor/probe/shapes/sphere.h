// A probe with the shape of a sphere.
#pragma once

#include "core/sensor/probe/shapes/probe_form.h"

namespace taxel {

struct ProbeSphere {
  static constexpr const char *kWord = "sphere", *kLabel = "Sphere";
  static constexpr bool kIsRound = true;  ///< a turn about z changes nothing
  static constexpr FieldKind kField = FieldKind::medial_axis;
  double radius = 0.005;  ///< [m]

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"radius", "Radius", "", FieldQuantity::length, FieldRange::positive}, radius);
  }
  /// Reduces the size to a radius [m].
  void shrink_to(double limit) { radius = std::min(radius, limit); }
  /// Throws Error if the radius is not greater than 0.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeSphere&) const = default;
};

}  // namespace taxel
