#include "core/run/recording/curve_pairs.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

/// Returns the largest difference between two curves, or `limit` if the difference reaches it.
double difference_below(std::span<const double> a, std::span<const double> b, double limit) {
  double largest = 0;
  for (std::size_t row = 0; row < a.size() && largest < limit; ++row)
    largest = std::max(largest, std::abs(a[row] - b[row]));
  return std::min(largest, limit);
}

}  // namespace

std::vector<int> find_leaders(const std::vector<std::span<const double>>& curves, std::span<const int> twins) {
  std::vector<int> leaders(curves.size(), -1);
  std::vector<bool> is_paired(curves.size(), false);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::span<const double> curve = curves[i];
    if (curve.empty()) continue;
    const auto peak_row = static_cast<std::size_t>(std::max_element(curve.begin(), curve.end()) - curve.begin());
    double nearest = kPairDistance * curve[peak_row];
    for (std::size_t j = 0; j < i; ++j) {
      if (is_paired[j] || (!twins.empty() && twins[i] != static_cast<int>(j))) continue;
      // Most pairs of curves already differ by `limit` at the peak of this curve.
      if (!(std::abs(curve[peak_row] - curves[j][peak_row]) < nearest)) continue;
      const double difference = difference_below(curve, curves[j], nearest);
      if (difference < nearest) nearest = difference, leaders[i] = static_cast<int>(j);
    }
    if (leaders[i] >= 0) is_paired[i] = is_paired[static_cast<std::size_t>(leaders[i])] = true;
  }
  return leaders;
}

}  // namespace taxel
