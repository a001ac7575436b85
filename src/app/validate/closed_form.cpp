#include "app/validate/closed_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taxel {

ClosedFormCheck CheckedCase::limit(const std::string& quantity, const std::string& unit, double computed,
                                   Relation relation, double limit) const {
  const double excess = relation == Relation::at_most ? computed - limit : limit - computed;
  // This comparison lets a computed NaN become a NaN error, which fails.
  const double error = excess <= 0 ? 0 : excess / std::abs(limit);
  return {form, setting, quantity, unit, computed, limit, error, 0, relation};
}

void Statistic::add(double computed, double exact) {
  const double error = std::abs(computed - exact) / std::abs(exact);
  computed_sum_ += computed;
  exact_sum_ += exact;
  error_sum_ += error;
  ++count_;
  constexpr double kRounding = 1e-12;  // the first of nearly equal errors wins, on every machine
  const bool worse = !std::isnan(worst_error_) && !(error < worst_error_ + kRounding);  // a NaN remains the worst
  if (count_ == 1 || worse) {
    worst_error_ = error;
    worst_computed_ = computed;
    worst_exact_ = exact;
  }
}

ClosedFormCheck Statistic::mean(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                double bound) const {
  return {about.form,
          about.setting,
          fmt::format("{}, mean of {}", quantity, count_),
          unit,
          computed_sum_ / count_,
          exact_sum_ / count_,
          mean_error(),
          bound,
          Relation::equal};
}

ClosedFormCheck Statistic::worst(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                 double bound) const {
  return {about.form,   about.setting,   fmt::format("{}, worst of {}", quantity, count_),
          unit,         worst_computed_, worst_exact_,
          worst_error_, bound,           Relation::equal};
}

}  // namespace taxel
