// The solution of the equation that implicit_wrenches.h states.
//
// Twists are numbers of one unit, angular velocities times the size of the contact, so that residuals can be compared.
// One evaluation takes the laws of all pairs and one linear solve with their secants. Since |t| grows less than
// linearly in |v|, each such solve lowers the energy of the step, but it may be slow; Anderson mixing of up to six
// changes (Walker, Ni 2011) extrapolates from the last iterates. Its least-squares problem is solved by Gram-Schmidt
// with the newest changes first, and a change that is nearly a combination of newer ones is left out.
//
// Pitfalls: a residual that grows takes the mixing back to a plain solve. After eight evaluations a growing residual
// means a cycle, which a step half way between iterate and image leaves. The wrench is that of the last linear solve,
// so twist and wrench agree to the last bit even if the iteration ends early. Theory: docs/theory/sim.md, "The implicit
// step".
#include "core/sim/plugin/forces/implicit_wrenches.h"
#include "core/hydro/kernel/covered_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taxel {
namespace {

constexpr int kMostEvaluations = 60;
constexpr double kResidual = 1e-7;
constexpr int kMixed = 8;  // evaluations after which a residual that grows means a cycle, which a halved step leaves
constexpr std::size_t kColumns = 6;     // largest number of columns in the Anderson mixing
constexpr double kIndependent = 1e-12;  // smallest independent fraction of a column's square

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
void subtract(std::vector<double>& a, double s, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= s * b[i];
}
void subtract_into(std::vector<double>& out, const std::vector<double>& a, const std::vector<double>& b) {
  out.resize(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] - b[i];
}

/// Writes a twist in variables of one unit: (linear, length * angular).
void scale_into(double* out, const Twist& V, double length) {
  for (int i = 0; i < 3; ++i) {
    out[i] = V.linear[i];
    out[i + 3] = length * V.angular[i];
  }
}
Twist unscaled(const double* v, double length) {
  return {dvec3(v[0], v[1], v[2]), dvec3(v[3], v[4], v[5]) / length};
}

}  // namespace

void ImplicitWrenches::begin(std::size_t pairs, double timestep) {
  const std::size_t n = 6 * pairs;
  timestep_ = timestep;
  pairs_.assign(pairs, {});
  A_.assign(n * n, 0);
  M_.resize(n * n);
  S_.resize(6 * n);
  for (Vector* v : {&elastic_, &free_, &v_, &image_, &residual_, &last_image_, &last_residual_}) v->assign(n, 0);
  columns_ = 0;
}

void ImplicitWrenches::set_inverse_inertia(std::size_t i, std::size_t j, const Matrix6& A_ij) {
  const std::size_t n = 6 * pairs_.size();
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t c = 0; c < 6; ++c) {
      const double scale = (r < 3 ? 1 : pairs_[i].length) * (c < 3 ? 1 : pairs_[j].length);
      A_[(6 * i + r) * n + 6 * j + c] = timestep_ * scale * A_ij[r][c];
    }
  }
}

/// Solves M_ x = image_ in place, by elimination with row pivoting. M_ = I + h A S is never singular, because A and S
/// are positive semi-definite.
void ImplicitWrenches::eliminate() {
  const std::size_t n = image_.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(M_[i * n + k]) > std::abs(M_[pivot * n + k])) pivot = i;
    if (pivot != k) std::swap_ranges(&M_[k * n], &M_[k * n] + n, &M_[pivot * n]);
    std::swap(image_[k], image_[pivot]);
    const double* row = &M_[k * n];
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = M_[i * n + k] / row[k];
      if (f == 0) continue;
      double* other = &M_[i * n];
      for (std::size_t j = k; j < n; ++j) other[j] -= f * row[j];
      image_[i] -= f * image_[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) image_[k] -= M_[k * n + j] * image_[j];
    image_[k] /= M_[k * n + k];
  }
}

/// Does one linear solve: (I + h A S) V = V_free + h A elastic, with S and elastic at `v`.
void ImplicitWrenches::image_of(const Vector& v, const Law& law) {
  const std::size_t n = v.size();
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const double length = pairs_[p].length;
    const Traction t = law(p, unscaled(&v[6 * p], length));
    scale_into(&elastic_[6 * p], {t.elastic.force, t.elastic.torque}, 1 / length);
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = 0; c < 6; ++c)
        S_[36 * p + 6 * r + c] = t.secant[r][c] / ((r < 3 ? 1 : length) * (c < 3 ? 1 : length));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double* A = &A_[i * n];
    double sum = free_[i];
    for (std::size_t k = 0; k < n; ++k) sum += A[k] * elastic_[k];
    image_[i] = sum;
    double* row = &M_[i * n];
    std::fill_n(row, n, 0.0);
    row[i] = 1;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t c = 0; c < 6; ++c) row[k / 6 * 6 + c] += A[k] * S_[6 * k + c];
  }
  eliminate();
}

/// Computes the next iterate (Walker, Ni 2011): image - sum gamma_i d_image_i, where gamma minimises |residual - sum
/// gamma_i d_residual_i|. Uses Gram-Schmidt with the newest columns first; a column that is nearly a combination of
/// newer columns is left out.
void ImplicitWrenches::mix(bool grew) {
  if (grew) columns_ = 0;
  if (columns_ == kColumns) {
    std::rotate(images_.begin(), images_.begin() + 1, images_.end());
    std::rotate(residuals_.begin(), residuals_.begin() + 1, residuals_.end());
    --columns_;
  }
  images_.resize(kColumns);
  residuals_.resize(kColumns);
  subtract_into(images_[columns_], image_, last_image_);
  subtract_into(residuals_[columns_], residual_, last_residual_);
  ++columns_;
  q_.resize(kColumns);
  moved_.resize(kColumns);
  std::size_t used = 0;
  for (std::size_t k = columns_; k-- > 0;) {
    Vector &column = q_[used], &moved = moved_[used];
    column = residuals_[k];
    moved = images_[k];
    const double before = dot(column, column);
    for (std::size_t i = 0; i < used; ++i) {
      const double s = dot(q_[i], column);
      subtract(column, s, q_[i]);
      subtract(moved, s, moved_[i]);
    }
    const double after = dot(column, column);
    if (!(after > kIndependent * before)) continue;
    const double norm = std::sqrt(after);
    for (std::size_t i = 0; i < column.size(); ++i) {
      column[i] /= norm;
      moved[i] /= norm;
    }
    ++used;
  }
  v_ = image_;
  for (std::size_t i = 0; i < used; ++i) subtract(v_, dot(q_[i], residual_), moved_[i]);
}

ImplicitWrenches::Outcome ImplicitWrenches::solve(const Law& law) {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    scale_into(&free_[6 * p], pairs_[p].V_free, pairs_[p].length);
    scale_into(&v_[6 * p], pairs_[p].V_start, pairs_[p].length);
  }
  columns_ = 0;
  Outcome outcome;
  double last_size = 0;
  while (true) {
    image_of(v_, law);
    ++outcome.evaluations;
    subtract_into(residual_, image_, v_);
    double change = 0;
    for (std::size_t i = 0; i < image_.size(); ++i) change += (image_[i] - free_[i]) * (image_[i] - free_[i]);
    const double size = std::sqrt(dot(residual_, residual_));
    outcome.converged = size <= kResidual * std::sqrt(change);
    if (outcome.converged || outcome.evaluations == kMostEvaluations) break;
    if (outcome.evaluations > 1) {
      const bool has_grown = size > last_size;
      if (has_grown && outcome.evaluations > kMixed) {
        columns_ = 0;
        v_ = image_;
        subtract(v_, 0.5, residual_);  // halfway between the iterate and its image
      } else {
        mix(has_grown);
      }
    } else {
      v_ = image_;
    }
    last_image_ = image_;
    last_residual_ = residual_;
    last_size = size;
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    Pair& pair = pairs_[p];
    double w[6];
    for (std::size_t r = 0; r < 6; ++r) {
      w[r] = elastic_[6 * p + r];
      for (std::size_t c = 0; c < 6; ++c) w[r] -= S_[36 * p + 6 * r + c] * image_[6 * p + c];
    }
    pair.wrench = {dvec3(w[0], w[1], w[2]), dvec3(w[3], w[4], w[5]) * pair.length};
    pair.V_end = unscaled(&image_[6 * p], pair.length);
  }
  return outcome;
}

}  // namespace taxel
