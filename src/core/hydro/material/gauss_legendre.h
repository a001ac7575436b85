// Gauss-Legendre quadrature.
#pragma once

#include <cmath>
#include <vector>

#include "core/base/math.h"

namespace taxel {

struct QuadratureRule {
  std::vector<double> nodes, weights;
};

/// Adds the rule of `count` nodes on [low, high], exact for polynomials of degree 2 count - 1. The nodes are the roots
/// of the Legendre polynomial by Newton's method from cos(pi (i + 3/4)/(count + 1/2)) (Abramowitz and Stegun 25.4.30).
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
