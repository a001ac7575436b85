#include "core/run/fit/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taxel {
namespace {

constexpr double kStepEnds = 1e-5;  // of a parameter's scale
constexpr double kRidge = 1e-12;
constexpr double kNoInfluence = 1e-9;  // of the largest column: below it nothing depends on a parameter

double half_squares(const Eigen::VectorXd& e) {
  return 0.5 * e.squaredNorm();
}

/// Returns the step that minimises |J d + e| with damped A = J^T J and g = J^T e within the bounds. Parameters that
/// leave the bounds are put onto them, and the step of the others is computed again.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& A, const Eigen::VectorXd& g, const Eigen::VectorXd& lowest,
                             const Eigen::VectorXd& highest) {
  const Eigen::Index count = g.size();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(count);
  std::vector<bool> is_put(static_cast<std::size_t>(count), false);
  for (Eigen::Index round = 0; round < count; ++round) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < count; ++i)
      if (!is_put[static_cast<std::size_t>(i)]) free.push_back(i);
    if (free.empty()) break;
    Eigen::VectorXd put = step;
    for (const Eigen::Index i : free) put[i] = 0;
    const Eigen::VectorXd rest = g + A * put;
    const Eigen::VectorXd solved = Eigen::MatrixXd(A(free, free)).ldlt().solve(Eigen::VectorXd(-rest(free)));
    bool all_within = true;
    for (std::size_t n = 0; n < free.size(); ++n) {
      const Eigen::Index i = free[n];
      step[i] = std::clamp(solved[static_cast<Eigen::Index>(n)], lowest[i], highest[i]);
      is_put[static_cast<std::size_t>(i)] = step[i] != solved[static_cast<Eigen::Index>(n)];
      all_within = all_within && !is_put[static_cast<std::size_t>(i)];
    }
    if (all_within) break;
  }
  return step;
}

}  // namespace

LeastSquaresPoint minimise(const LeastSquares& problem, const Eigen::VectorXd& start, int iterations) {
  constexpr double kFirstDamping = 1e-3, kMostDamping = 1e8;
  LeastSquaresPoint best{start.cwiseMax(problem.lower).cwiseMin(problem.upper), 0};
  Eigen::VectorXd e = problem.residuals(best.p);
  best.cost = half_squares(e);
  double damping = kFirstDamping;
  for (int i = 0; i < iterations && best.p.size() > 0; ++i) {
    const Eigen::MatrixXd J = problem.derivatives(best.p);
    const Eigen::MatrixXd A = J.transpose() * J;
    const Eigen::VectorXd g = J.transpose() * e;
    double moved = 0;
    for (bool improved = false; !improved && damping < kMostDamping;) {
      Eigen::MatrixXd damped = A;
      damped.diagonal() += damping * A.diagonal().cwiseMax(1e-300);
      const Eigen::VectorXd p = best.p + bounded_step(damped, g, problem.lower - best.p, problem.upper - best.p);
      const Eigen::VectorXd tried = problem.residuals(p);
      const double cost = half_squares(tried);
      improved = std::isfinite(cost) && cost < best.cost;
      if (improved) {
        moved = ((p - best.p).cwiseQuotient(problem.scale)).cwiseAbs().maxCoeff();
        best = {p, cost};
        e = tried;
        damping = std::max(damping / 5, 1e-9);
      } else {
        damping *= 6;
      }
    }
    if (moved <= kStepEnds) break;
  }
  return best;
}

Certainty certainty_of(const Eigen::MatrixXd& J, double variance) {
  const Eigen::Index count = J.cols();
  Certainty certainty;
  certainty.standard_errors.assign(static_cast<std::size_t>(count), std::numeric_limits<double>::infinity());
  certainty.correlations.assign(static_cast<std::size_t>(count), std::vector<double>(static_cast<std::size_t>(count)));
  for (Eigen::Index i = 0; i < count; ++i)
    certainty.correlations[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] = 1;
  std::vector<Eigen::Index> used;
  const Eigen::VectorXd norms = J.colwise().norm();
  for (Eigen::Index i = 0; i < count; ++i)
    if (norms[i] > kNoInfluence * std::max(norms.maxCoeff(), 1e-300)) used.push_back(i);
  const auto size = static_cast<Eigen::Index>(used.size());
  if (size == 0) return certainty;
  // Columns of length 1, so that parameters of different units are comparable.
  Eigen::MatrixXd S(J.rows(), size);
  for (Eigen::Index i = 0; i < size; ++i)
    S.col(i) = J.col(used[static_cast<std::size_t>(i)]) / norms[used[static_cast<std::size_t>(i)]];
  Eigen::MatrixXd A = S.transpose() * S;
  A.diagonal().array() += kRidge;  // columns that are equal get a large variance and the correlation 1
  const Eigen::MatrixXd inverse = A.ldlt().solve(Eigen::MatrixXd::Identity(size, size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto a = static_cast<std::size_t>(used[static_cast<std::size_t>(i)]);
    certainty.standard_errors[a] =
        std::sqrt(std::max(variance * inverse(i, i), 0.0)) / norms[used[static_cast<std::size_t>(i)]];
    for (Eigen::Index j = 0; j < size; ++j)
      if (i != j)
        certainty.correlations[a][static_cast<std::size_t>(used[static_cast<std::size_t>(j)])] =
            std::clamp(inverse(i, j) / std::sqrt(inverse(i, i) * inverse(j, j)), -1.0, 1.0);
  }
  return certainty;
}

}  // namespace taxel
