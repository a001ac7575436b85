// Numerical integration: rules for triangles and polygons, and Gauss-Legendre rules for an interval.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/base/math.h"
#include "core/hydro/contact_surface.h"

namespace taxel {

/// A point of a quadrature rule: barycentric weights (the third is 1 - u - v), and its weight as a fraction of the
/// area.
struct QuadraturePoint {
  double u = 0, v = 0, weight = 0;
};

/// Rule that is exact for polynomials of degree 2: three points inside the triangle with equal weights (Strang, Fix
/// 1973).
inline constexpr std::array<QuadraturePoint, 3> kTriangleDegree2{
    {{1.0 / 6, 1.0 / 6, 1.0 / 3}, {1.0 / 6, 2.0 / 3, 1.0 / 3}, {2.0 / 3, 1.0 / 6, 1.0 / 3}}};

/// Rule that is exact for polynomials of degree 4: six points inside the triangle with positive weights (Dunavant
/// 1985), a = (8 - sqrt(10) +- sqrt(38 - 44 sqrt(2/5)))/18, w = (620 +- sqrt(213125 - 53320 sqrt(10)))/3720.
inline constexpr std::array<QuadraturePoint, 6> kTriangleDegree4 = [] {
  constexpr double a = 0.44594849091596489, wa = 0.22338158967801147;
  constexpr double b = 0.09157621350977074, wb = 0.10995174365532187;
  return std::array<QuadraturePoint, 6>{
      {{a, a, wa}, {a, 1 - 2 * a, wa}, {1 - 2 * a, a, wa}, {b, b, wb}, {b, 1 - 2 * b, wb}, {1 - 2 * b, b, wb}}};
}();

/// A point of a rule, and its weight in a coarser rule of the same points.
struct EmbeddedPoint {
  double u = 0, v = 0, weight = 0, coarse = 0;
};

/// Rule that is exact for polynomials of degree 5: seven points inside the triangle, the centroid first (Radon 1948),
/// with orbits a = (6 -+ sqrt(15))/21, w = (155 -+ sqrt(15))/1200, and 9/40 at the centroid. The coarser rule has the
/// centroid and the outer orbit, with the weights 1/(12 (1 - 3a)^2) that make it exact for degree 2. The difference of
/// both rules is a measure of the third derivatives.
inline constexpr std::array<EmbeddedPoint, 7> kTriangleDegree5 = [] {
  constexpr double a = 0.10128650732345634, wa = 0.12593918054482715, ca = 1 / (12 * (1 - 3 * a) * (1 - 3 * a));
  constexpr double b = 0.47014206410511509, wb = 0.13239415278850618;
  return std::array<EmbeddedPoint, 7>{{{1.0 / 3, 1.0 / 3, 0.225, 1 - 3 * ca},
                                       {a, a, wa, ca},
                                       {a, 1 - 2 * a, wa, ca},
                                       {1 - 2 * a, a, wa, ca},
                                       {b, b, wb, 0},
                                       {b, 1 - 2 * b, wb, 0},
                                       {1 - 2 * b, b, wb, 0}}};
}();

/// Calls f(a, b, c, area) for the triangles of a polygon, which form a fan about its first corner. Merging may have
/// moved corners slightly, so the areas are scaled to add up to the polygon's area. There is no call if the corners
/// span no area.
template <class F>
void for_each_triangle(const ContactSurface& surface, const ContactPolygon& polygon, F&& f) {
  const dvec3* corners = surface.vertices.data() + polygon.first;
  const auto area = [&](int i) {
    return 0.5 * glm::dot(glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]), polygon.normal);
  };
  double sum = 0;
  for (int i = 1; i + 1 < polygon.count; ++i) sum += area(i);
  if (!(sum > 0)) return;
  for (int i = 1; i + 1 < polygon.count; ++i) f(corners[0], corners[i], corners[i + 1], area(i) * (polygon.area / sum));
}

/// Calls f(x, dA) for points of the polygon whose sums are exact for polynomials of the rule's degree.
template <class Rule, class F>
void for_each_quadrature_point(const ContactSurface& surface, const ContactPolygon& polygon, const Rule& rule, F&& f) {
  for_each_triangle(surface, polygon, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
    for (const QuadraturePoint& q : rule) f(q.u * a + q.v * b + (1 - q.u - q.v) * c, q.weight * area);
  });
}

/// A rule for an interval.
struct QuadratureRule {
  std::vector<double> nodes, weights;
};

/// Adds the Gauss-Legendre rule of `count` nodes on [low, high], exact for polynomials of degree 2 count - 1. The nodes
/// are the roots of the Legendre polynomial by Newton's method from cos(pi (i + 3/4)/(count + 1/2)) (Abramowitz and
/// Stegun 25.4.30).
inline void add_gauss_legendre(double low, double high, int count, QuadratureRule& rule) {
  for (int i = 0; i < count; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int step = 0; step < 8; ++step) {
      double before = 1.0, value = x;
      for (int k = 2; k <= count; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    rule.nodes.push_back(0.5 * (low + high) - 0.5 * (high - low) * x);
    rule.weights.push_back((high - low) / ((1.0 - x * x) * slope * slope));
  }
}

}  // namespace taxel
