// A contact surface reduced to few points, for laws that are evaluated many times on one surface.
#pragma once

#include <vector>

#include "core/hydro/kernel/traction_sums.h"

namespace taxel {

/// The pressure force of each polygon at its centre of pressure, or, for a polygon that is a large fraction of the
/// surface, at the points of a quadrature rule. The elastic wrench is exactly that of the surface, and so are friction
/// and damping if the motion is a translation. If the motion has a rotation, friction and damping differ from
/// traction() of the surface by second order in the size of the polygons. On surfaces of many polygons an evaluation
/// costs a small fraction of traction().
class TractionPoints {
 public:
  /// Replaces the points by those of a surface. Reuses the memory.
  void assign(const ContactSurface& surface);

  /// Returns the traction, like traction(surface, pair, V_BA).
  [[nodiscard]] Traction evaluate(const PairProperties& pair, const Twist& V_BA) const;

  /// Returns pressure_wrench() of the surface.
  [[nodiscard]] const Wrench& pressure_wrench() const { return pressure_wrench_; }

 private:
  /// Adds a force of `push` newtons at x, along the unit vector n.
  void add(const dvec3& x, const dvec3& n, double push);

  std::vector<TractionBlock> blocks_;
  std::size_t count_ = 0;
  Wrench pressure_wrench_;
};

}  // namespace taxel
