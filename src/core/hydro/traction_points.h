// A contact surface reduced to few points, for laws that are evaluated many times on one surface: friction, damping and
// pressure are summed over eight points at a time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/hydro/traction.h"

namespace taxel {

/// Eight points of a contact surface, frame A. Places without a point hold zeros and count for nothing.
struct alignas(64) TractionBlock {
  static constexpr std::size_t kPoints = 8;
  double x[3][kPoints];  ///< position [m]
  double n[3][kPoints];  ///< unit normal that pushes A
  double m[3][kPoints];  ///< x cross n [m]
  double push[kPoints];  ///< integral of p0 dA [N]
};

/// Over the points that still push, 1 - d vn > 0: the elastic wrench, and the sums of which the secant J^T K J is made,
/// J = [I, -[x]], K = f I + g n n^T, f = mu (1 - d vn) phi(|vt|) push and g = d push - f.
struct TractionSums {
  std::array<double, 3> force, torque;  ///< elastic
  double f;
  std::array<double, 3> fx, fxx, fxy;  ///< f x; f times xx yy zz; f times yz zx xy
  std::array<double, 21> outer;        ///< g u u^T, u = J^T n = (n, m): the upper triangle by rows
};
TractionSums sum_traction(std::span<const TractionBlock> blocks, const PairProperties& pair, const Twist& V_BA);

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
