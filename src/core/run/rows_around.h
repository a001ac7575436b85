// Place of a time among the times of rows, for linear interpolation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taxel {

/// Two rows of a table, and the place between them.
struct RowsAround {
  std::size_t before = 0, after = 0;
  double fraction = 0;  ///< 0 at `before`, 1 at `after`
};

/// Returns the rows around a time. `times` ascend and are not empty. The first row is held before it, and the last row
/// after it. The fraction is exactly 0 or 1 at the time of a row.
inline RowsAround rows_around(const std::vector<double>& times, double time) {
  const auto next = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  if (next == 0) return {};
  if (next == times.size()) return {next - 1, next - 1, 0};
  return {next - 1, next, (time - times[next - 1]) / (times[next] - times[next - 1])};
}

}  // namespace taxel
