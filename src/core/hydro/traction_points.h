// A contact surface reduced to few points, for laws that are evaluated many times on the same surface.
#pragma once

#include <vector>

#include "core/hydro/kernel/traction_sums.h"

namespace taxel {

/// Each polygon's pressure force at its centre of pressure; of a polygon that is a large part of the surface, at the
/// points of a quadrature rule. The elastic wrench is that of the surface, and so are friction and damping of a surface
/// that moves without turning; of one that turns, they differ from traction() of the surface by the second order of the
/// polygons' size. On surfaces of many polygons an evaluation costs a small part of traction()'s.
class TractionPoints {
 public:
  /// Keeps the memory of the last surface.
  void assign(const ContactSurface& surface);

  /// As traction(surface, pair, V_BA).
  [[nodiscard]] Traction evaluate(const PairProperties& pair, const Twist& V_BA) const;

  /// pressure_wrench(surface) of the surface.
  [[nodiscard]] const Wrench& pressure_wrench() const { return pressure_wrench_; }

 private:
  /// A force of `push` newtons at x, along the unit vector n.
  void add(const dvec3& x, const dvec3& n, double push);

  std::vector<TractionBlock> blocks_;
  std::size_t count_ = 0;
  Wrench pressure_wrench_;
};

}  // namespace taxel
