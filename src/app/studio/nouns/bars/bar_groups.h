// The places of bars that belong to several sensors.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace taxel::ui {

/// The columns of the bars of one sensor [pixels].
struct BarSpan {
  float x0 = 0, x1 = 0;  ///< left and right end of the group
  float step = 0;        ///< width of the column of one bar
  [[nodiscard]] float column(std::size_t bar) const { return x0 + static_cast<float>(bar) * step; }
};

/// Divides the room from x0 to x1 into groups of `counts` columns of equal width, with a gap of at most `gap` between
/// two groups. Gaps take at most a third of the room.
[[nodiscard]] std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, float x0, float x1, float gap);

}  // namespace taxel::ui
