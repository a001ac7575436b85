#include "core/hydro/material/hardness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

void check_hardness(const char* field, double hardness) {
  if (!(hardness >= kHardnessTolerance && hardness <= 100.0 - kHardnessTolerance))
    throw Error("", field,
                fmt::format("must be from {} to {}, is {}", kHardnessTolerance, 100.0 - kHardnessTolerance, hardness));
}

/// Gent 1958, "On the relation between indentation hardness and Young's modulus", eq. 8, in Pa.
double gent(double s) {
  return 1e6 * 0.0981 * (56.0 + 7.62336 * s) / (0.137505 * (254.0 - 2.54 * s));
}

/// Qi, Joyce and Boyce 2003, "Durometer hardness and the stress-strain behavior of elastomeric materials": log10 of E
/// in MPa, fitted to nonlinear finite elements for 20 < s < 80. In Pa.
double qi(double s) {
  return 1e6 * std::pow(10.0, 0.0235 * s - 0.6403);
}

/// ASTM D2240, type OO: a ball of 2.38 mm diameter protrudes by 2.54 mm at 0; the spring pushes with 0.203 N and
/// 0.00908 N for each unit. F = 4/3 E/(1 - nu^2) sqrt(R) d^1.5 with nu = 1/2 (Hertz 1882). In Pa.
double ball_on_spring(double s) {
  const double force = 0.203 + 0.00908 * s, depth = 2.54e-3 * (1.0 - 0.01 * s), radius = 1.19e-3;
  return 0.75 * 0.75 * force / (std::sqrt(radius) * std::pow(depth, 1.5));
}

}  // namespace

YoungsEstimate youngs_from_shore_a(double hardness) {
  check_hardness("shore_a", hardness);
  YoungsEstimate estimate{gent(hardness), gent(hardness - kHardnessTolerance),
                          gent(std::min(hardness + kHardnessTolerance, 99.0)), "Gent 1958"};
  if (hardness >= 20.0 && hardness <= 80.0) {
    estimate.low = std::min(estimate.low, qi(hardness - kHardnessTolerance));
    estimate.high = std::max(estimate.high, qi(hardness + kHardnessTolerance));
    estimate.source = "Gent 1958; range with Qi, Joyce and Boyce 2003";
  }
  return estimate;
}

YoungsEstimate youngs_from_shore_00(double hardness) {
  check_hardness("shore_00", hardness);
  return {ball_on_spring(hardness), ball_on_spring(hardness - kHardnessTolerance),
          ball_on_spring(std::min(hardness + kHardnessTolerance, 99.0)),
          "Hertz 1882 for ball and spring of ASTM D2240, as Mix and Giacomin 2011"};
}

}  // namespace taxel
