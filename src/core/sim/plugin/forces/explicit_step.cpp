#include "core/sim/plugin/forces/explicit_step.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

constexpr int kMostSweeps = 30;  // Jacobi's method converges quadratically and needs about 6 sweeps

Matrix6 product(const Matrix6& a, const Matrix6& b) {
  Matrix6 c{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t j = 0; j < 6; ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// Rotates rows and columns p and q of the symmetric matrix m so that m[p][q] = 0, and the columns p and q of `vectors`
/// by the same rotation.
void rotate(Matrix6& m, Matrix6& vectors, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = m[k][p], b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = m[p][k], b = m[q][k], v = vectors[k][p], w = vectors[k][q];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
    vectors[k][p] = c * v - s * w;
    vectors[k][q] = s * v + c * w;
  }
}

/// Returns true if the elements off the diagonal are rounding errors.
bool diagonal(const Matrix6& m) {
  constexpr double kRounding = 1e-30;  // largest rounding error, as a fraction of the sum of squares
  double on = 0, off = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) (i == j ? on : off) += m[i][j] * m[i][j];
  return !(off > kRounding * on);
}

/// Diagonalises m: the eigenvalues are then on its diagonal, the eigenvectors in the columns of the result (Jacobi
/// 1846).
Matrix6 diagonalize(Matrix6& m) {
  Matrix6 vectors{};
  for (std::size_t i = 0; i < 6; ++i) vectors[i][i] = 1;
  for (int sweep = 0; sweep < kMostSweeps && !diagonal(m); ++sweep) {
    for (std::size_t p = 0; p < 6; ++p)
      for (std::size_t q = p + 1; q < 6; ++q) rotate(m, vectors, p, q);
  }
  return vectors;
}

/// Returns L with L L^T = A.
Matrix6 root_of(Matrix6 A) {
  Matrix6 L = diagonalize(A);
  for (std::size_t j = 0; j < 6; ++j) {
    const double root = std::sqrt(std::max(0.0, A[j][j]));
    for (std::size_t i = 0; i < 6; ++i) L[i][j] *= root;
  }
  return L;
}

/// Returns the largest eigenvalue of a symmetric matrix.
double largest_eigenvalue(Matrix6 m) {
  diagonalize(m);
  double largest = m[0][0];
  for (std::size_t i = 1; i < 6; ++i) largest = std::max(largest, m[i][i]);
  return largest;
}

}  // namespace

double largest_stable_step(const ContactMode& mode, double timestep) {
  const Matrix6 L = root_of(mode.inverse_inertia), L_T = transposed(L);
  const Matrix6 K = product(L_T, product(mode.stiffness, L)), S = product(L_T, product(mode.damping, L));
  const auto stable = [&](double h) {
    Matrix6 m{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) m[i][j] = h * h * K[i][j] - 2 * h * S[i][j];
    return largest_eigenvalue(m) < kStepLimit;
  };
  if (stable(timestep)) return timestep;
  // The eigenvalue is a maximum of functions h^2 a - 2 h b with a, b >= 0, so all steps above an unstable h are
  // unstable.
  double lo = 0, hi = timestep;
  for (int i = 0; i < 200 && hi - lo > 1e-9 * hi; ++i) {
    const double h = 0.5 * (lo + hi);
    (stable(h) ? lo : hi) = h;
  }
  return lo;
}

double stiffest_mode_bound(const Matrix6& A, double linear_stiffness, double reach) {
  // Bounds u^T A u for |n| = 1 and |x cross n| <= reach; each block is at most its Frobenius norm.
  double linear = 0, coupling = 0, angular = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      linear += A[i][j] * A[i][j];
      coupling += A[i][j + 3] * A[i][j + 3];
      angular += A[i + 3][j + 3] * A[i + 3][j + 3];
    }
  }
  return linear_stiffness * (std::sqrt(linear) + 2 * reach * std::sqrt(coupling) + reach * reach * std::sqrt(angular));
}

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
