// One row of the validation: what was computed, what it must be, how far apart they are.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace taxel {

enum class Relation { equal, at_most, at_least };

/// One quantity of one case.
struct ClosedFormCheck {
  std::string form;      ///< "A1"
  std::string setting;   ///< bodies, sizes, depth
  std::string quantity;  ///< "force, mean of 200"
  std::string unit;      ///< "1" where it has none
  double computed = 0;   ///< mean over the poses, or the pose of the largest error
  double exact = 0;      ///< of the closed form; the limit where `relation` is an inequality
  double error = 0;      ///< relative to `exact`; for an inequality how far it is broken, 0 where it holds
  double bound = 0;      ///< largest error allowed
  Relation relation = Relation::equal;
  [[nodiscard]] bool pass() const { return error <= bound; }
};
using ClosedFormChecks = std::vector<ClosedFormCheck>;

/// What the checks of one case have in common.
struct CheckedCase {
  std::string form, setting;

  /// `computed` must be at most (or at least) `limit`.
  [[nodiscard]] ClosedFormCheck limit(const std::string& quantity, const std::string& unit, double computed,
                                      Relation relation, double limit) const;
};

/// Relative errors of one quantity over many poses.
class Statistic {
 public:
  void add(double computed, double exact);
  /// Mean of the computed and of the exact values, mean of the sizes of the errors.
  [[nodiscard]] ClosedFormCheck mean(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                     double bound) const;
  /// The pose of the largest error.
  [[nodiscard]] ClosedFormCheck worst(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                      double bound) const;
  [[nodiscard]] double mean_error() const { return error_sum_ / count_; }

 private:
  double computed_sum_ = 0, exact_sum_ = 0, error_sum_ = 0;
  double worst_computed_ = 0, worst_exact_ = 0;
  double worst_error_ = std::numeric_limits<double>::quiet_NaN();  ///< before the first pose
  int count_ = 0;
};

}  // namespace taxel
