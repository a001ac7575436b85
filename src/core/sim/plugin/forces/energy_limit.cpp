#include "core/sim/plugin/forces/energy_limit.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

/// Returns w . A w.
double mobility(const Wrench& w, const Matrix6& A) {
  const std::array<double, 6> v{w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z};
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) sum += v[i] * A[i][j] * v[j];
  return sum;
}

}  // namespace

double power(const Wrench& w, const Twist& V) {
  return glm::dot(w.force, V.linear) + glm::dot(w.torque, V.angular);
}

double release_share(double left, const Wrench& w, const Twist& V, const Twist& V_end, const Matrix6& A,
                     double timestep) {
  // (h/2) s w.(V + V_end + (s - 1) h A w) = linear s + square s^2
  const double square = 0.5 * timestep * timestep * mobility(w, A);
  const double linear = 0.5 * timestep * (power(w, V) + power(w, V_end)) - square;
  if (linear + square <= left || !(square > 0)) return 1;
  const double root = std::sqrt(std::max(0.0, linear * linear + 4 * square * left));
  return std::clamp((root - linear) / (2 * square), 0.0, 1.0);
}

double stiffness_growth(double held, const Wrench& w, const Twist& V, const Matrix6& A) {
  const double P = power(w, V), response = mobility(w, A);
  if (!(P < 0 && response > 0 && held > 0)) return 1;
  return std::sqrt(1 + P * P / (2 * response * held));
}

}  // namespace taxel
