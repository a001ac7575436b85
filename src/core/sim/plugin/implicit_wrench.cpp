#include "core/sim/plugin/implicit_wrench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace taxel {
namespace {

using Vector6 = std::array<double, 6>;

constexpr int kMaxEvaluations = 30;
constexpr double kTolerance = 1e-7;
constexpr std::size_t kHistory = 4;  // columns of the Anderson mixing

Vector6 stack(const dvec3& a, const dvec3& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
Vector6 operator-(Vector6 a, const Vector6& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] -= b[i];
  return a;
}
Vector6 operator*(const Matrix6& m, const Vector6& v) {
  Vector6 r{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) r[i] += m[i][j] * v[j];
  return r;
}
double dot(const Vector6& a, const Vector6& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}
void subtract(Vector6& a, double s, const Vector6& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] -= s * b[i];
}

/// Solves M x = b by elimination with row pivoting. M is I + h A S: never singular, for A and S are positive
/// semi-definite.
Vector6 solve(Matrix6 m, Vector6 b) {
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 6; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < 6; ++i) {
      const double f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 6; ++j) m[i][j] -= f * m[k][j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = 6; k-- > 0;) {
    for (std::size_t j = k + 1; j < 6; ++j) b[k] -= m[k][j] * b[j];
    b[k] /= m[k][k];
  }
  return b;
}

/// The last few changes of iterate and residual, for Anderson mixing: the next iterate is the combination of the last
/// ones whose residual, taken as linear, is least.
class Mixing {
 public:
  void clear() { count_ = 0; }
  void add(const Vector6& d_image, const Vector6& d_residual) {
    const std::size_t slot = next_++ % kHistory;
    d_image_[slot] = d_image;
    d_residual_[slot] = d_residual;
    count_ = std::min(count_ + 1, kHistory);
  }
  /// image - sum gamma_i d_image_i, gamma minimising |residual - sum gamma_i d_residual_i|. Newest columns first, by
  /// Gram-Schmidt; a column that is nearly a combination of newer ones is left out.
  [[nodiscard]] Vector6 next(Vector6 image, Vector6 residual) const {
    std::array<Vector6, kHistory> q{}, images{};
    std::size_t used = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t slot = (next_ + kHistory - 1 - k) % kHistory;
      Vector6 column = d_residual_[slot], moved = d_image_[slot];
      const double before = dot(column, column);
      for (std::size_t i = 0; i < used; ++i) {
        const double s = dot(q[i], column);
        subtract(column, s, q[i]);
        subtract(moved, s, images[i]);
      }
      const double after = dot(column, column);
      if (!(after > 1e-12 * before)) continue;
      const double norm = std::sqrt(after);
      for (std::size_t i = 0; i < 6; ++i) {
        q[used][i] = column[i] / norm;
        images[used][i] = moved[i] / norm;
      }
      ++used;
    }
    for (std::size_t i = 0; i < used; ++i) subtract(image, dot(q[i], residual), images[i]);
    return image;
  }

 private:
  std::array<Vector6, kHistory> d_image_{}, d_residual_{};
  std::size_t count_ = 0, next_ = 0;
};

/// The equation in variables of one unit: (linear, length * angular) for twists.
class Equation {
 public:
  Equation(const ImplicitStep& step, const std::function<Traction(const Twist&)>& law)
      : step_(step), law_(law), free_(scaled(step.V_free)) {}

  [[nodiscard]] Vector6 scaled(const Twist& V) const { return stack(V.linear, step_.length * V.angular); }
  [[nodiscard]] Twist unscaled(const Vector6& v) const {
    return {dvec3(v[0], v[1], v[2]), dvec3(v[3], v[4], v[5]) / step_.length};
  }
  [[nodiscard]] const Vector6& free() const { return free_; }

  /// One linear solve: (I + h A S) V = V_free + h A elastic, with S and elastic at `v`. Fills wrench_.
  Vector6 image(const Vector6& v) {
    const Traction t = law_(unscaled(v));
    Matrix6 hA = step_.inverse_inertia, S = t.secant;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const double scale = (i < 3 ? 1 : step_.length) * (j < 3 ? 1 : step_.length);
        hA[i][j] *= step_.timestep * scale;
        S[i][j] /= scale;
      }
    }
    Matrix6 M{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        M[i][j] = i == j ? 1 : 0;
        for (std::size_t k = 0; k < 6; ++k) M[i][j] += hA[i][k] * S[k][j];
      }
    }
    const Vector6 elastic = stack(t.elastic.force, t.elastic.torque / step_.length);
    Vector6 b = hA * elastic;
    for (std::size_t i = 0; i < 6; ++i) b[i] += free_[i];
    const Vector6 end = solve(M, b);
    wrench_ = elastic - S * end;
    return end;
  }
  /// elastic - S V of the last linear solve.
  [[nodiscard]] Wrench wrench() const {
    return {dvec3(wrench_[0], wrench_[1], wrench_[2]), dvec3(wrench_[3], wrench_[4], wrench_[5]) * step_.length};
  }

 private:
  const ImplicitStep& step_;
  const std::function<Traction(const Twist&)>& law_;
  Vector6 free_, wrench_{};
};

}  // namespace

ImplicitWrench solve_implicit_wrench(const ImplicitStep& step, const std::function<Traction(const Twist&)>& law) {
  Equation equation(step, law);
  Mixing mixing;
  ImplicitWrench result;
  Vector6 v = equation.scaled(step.V_start), last_image{}, last_residual{};
  double last_size = 0;
  while (true) {
    const Vector6 image = equation.image(v);
    const Vector6 residual = image - v, change = image - equation.free();
    const double size = std::sqrt(dot(residual, residual));
    ++result.evaluations;
    result.converged = size <= kTolerance * std::sqrt(dot(change, change));
    if (result.converged || result.evaluations == kMaxEvaluations) {
      result.wrench = equation.wrench();
      result.V_end = equation.unscaled(image);
      return result;
    }
    if (result.evaluations > 1) {
      if (size > last_size) mixing.clear();
      mixing.add(image - last_image, residual - last_residual);
    }
    last_image = image;
    last_residual = residual;
    last_size = size;
    v = result.evaluations > 1 ? mixing.next(image, residual) : image;
  }
}

}  // namespace taxel
