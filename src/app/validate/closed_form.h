// One row of the validation: a computed quantity, its exact value and the error.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace taxel {

enum class Relation { equal, at_most, at_least };

/// One quantity of one case against its closed form.
struct ClosedFormCheck {
  std::string form;      ///< "A1"
  std::string setting;   ///< bodies, sizes, depth
  std::string quantity;  ///< "force, mean of 200"
  std::string unit;      ///< "1" for a number without a unit
  double computed = 0;   ///< mean over the poses, or the value with the largest error
  double exact = 0;      ///< value of the closed form, or the limit of an inequality
  /// Relative to `exact`. For an inequality the amount by which it is violated, or 0.
  double error = 0;
  double bound = 0;  ///< largest allowed error
  Relation relation = Relation::equal;
  [[nodiscard]] bool pass() const { return error <= bound; }
};
using ClosedFormChecks = std::vector<ClosedFormCheck>;

/// The case that several checks share.
struct CheckedCase {
  std::string form, setting;

  /// Returns the check that `computed` is at most, or at least, `limit`.
  [[nodiscard]] ClosedFormCheck limit(const std::string& quantity, const std::string& unit, double computed,
                                      Relation relation, double limit) const;
};

/// Relative errors of one quantity over many poses.
class Statistic {
 public:
  void add(double computed, double exact);
  /// Returns the means of the computed values, the exact values and the absolute errors.
  [[nodiscard]] ClosedFormCheck mean(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                     double bound) const;
  /// Returns the values with the largest error.
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
