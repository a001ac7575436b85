// Numerical integration over a triangle.
#pragma once

#include <array>

namespace taxel {

/// Barycentric weights (the third is 1 - u - v) and the part of the area that a point stands for.
struct QuadraturePoint {
  double u = 0, v = 0, weight = 0;
};

/// Exact for polynomials of degree 4, six points inside the triangle, all weights positive (Dunavant 1985):
/// a = (8 - sqrt(10) +- sqrt(38 - 44 sqrt(2/5)))/18, w = (620 +- sqrt(213125 - 53320 sqrt(10)))/3720.
inline constexpr std::array<QuadraturePoint, 6> kTriangleDegree4 = [] {
  constexpr double a = 0.44594849091596489, wa = 0.22338158967801147;
  constexpr double b = 0.09157621350977074, wb = 0.10995174365532187;
  return std::array<QuadraturePoint, 6>{
      {{a, a, wa}, {a, 1 - 2 * a, wa}, {1 - 2 * a, a, wa}, {b, b, wb}, {b, 1 - 2 * b, wb}, {1 - 2 * b, b, wb}}};
}();

}  // namespace taxel
