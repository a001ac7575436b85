// Bounded nonlinear least squares, and the certainty of its parameters.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

namespace taxel {

/// A problem with the residuals e(p). Both functions get parameters within the bounds.
struct LeastSquares {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& p)> residuals;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& p)> derivatives;  ///< J, a column per parameter
  Eigen::VectorXd lower, upper;
  Eigen::VectorXd scale;  ///< size of a parameter, which judges whether a step still matters
};

/// A point of a problem, and half the sum of the squares there.
struct LeastSquaresPoint {
  Eigen::VectorXd p;
  double cost = 0;
};

/// Improves `start` by the method of Levenberg (1944) and Marquardt (1963), whose steps are cut at the bounds. Ends
/// after `iterations` steps, or when a step changes no parameter by more than 1e-5 of its scale.
LeastSquaresPoint minimise(const LeastSquares& problem, const Eigen::VectorXd& start, int iterations);

/// The certainty of parameters by the derivatives J of the residuals at a minimum.
struct Certainty {
  std::vector<double> standard_errors;            ///< infinity for a parameter on which nothing depends
  std::vector<std::vector<double>> correlations;  ///< 0 for such parameters
};

/// Returns the certainty for residuals of the variance `variance` that are independent: the covariance is
/// variance (J^T J)^-1.
Certainty certainty_of(const Eigen::MatrixXd& J, double variance);

}  // namespace taxel
