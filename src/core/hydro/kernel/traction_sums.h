// Friction, damping and pressure summed over the points of a contact, eight points at a time.
#pragma once

#include <array>
#include <span>

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

}  // namespace taxel
