// Round numbers along the axis of a chart, and their texts.
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// The numbers at which an axis has ticks.
struct AxisTicks {
  std::vector<double> values;  ///< ascending
  double step = 0;             ///< distance of two ticks; 0 if there are fewer than two
};

/// Returns at most `most` + 1 round numbers from `low` to `high`: multiples of 1, 2 or 5 times a power of 10. A
/// range with fewer than two of them gets the next finer ones. Returns `low` alone if the range is empty or an end is
/// not finite.
[[nodiscard]] AxisTicks axis_ticks(double low, double high, int most);

/// Returns the text of each tick, all with as many decimals as the step needs: "0.0", "0.5", "1.0". Very large and very
/// small numbers have a power of 10: "2e-07".
[[nodiscard]] std::vector<std::string> tick_texts(const AxisTicks& ticks);

}  // namespace taxel
