// Young's modulus from a hardness on one of Shore's scales.
#pragma once

#include <string>

namespace taxel {

/// A Young's modulus with the range that the hardness allows.
struct YoungsEstimate {
  double youngs = 0;         ///< [Pa]
  double low = 0, high = 0;  ///< range of all formulas, for a hardness within its tolerance [Pa]
  std::string source;        ///< formula and paper
};
/// Usual tolerance of a stated hardness, on each scale.
inline constexpr double kHardnessTolerance = 5.0;

/// From Shore A (Gent 1958; range with the fit of Qi, Joyce and Boyce 2003, made for 20 to 80). Throws
/// Error("", "shore_a", message) outside of 5 to 95.
YoungsEstimate youngs_from_shore_a(double hardness);

/// From Shore 00: Hertz's force of the ball of ASTM D2240, of an incompressible solid, equals the force of its spring
/// (the method of Mix and Giacomin 2011). Throws Error("", "shore_00", message) outside of 5 to 95.
YoungsEstimate youngs_from_shore_00(double hardness);

}  // namespace taxel
