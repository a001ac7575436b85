#include "app/studio/nouns/bars/bar_groups.h"

#include <algorithm>
#include <numeric>

namespace taxel::ui {

std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, float x0, float x1, float gap) {
  std::vector<BarSpan> spans;
  const std::size_t columns = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (columns == 0) return spans;
  const auto gaps = static_cast<float>(counts.size() - 1);
  const float between = gaps > 0 ? std::min(gap, (x1 - x0) / (3 * gaps)) : 0.0f;
  const float step = (x1 - x0 - gaps * between) / static_cast<float>(columns);
  float at = x0;
  for (const std::size_t count : counts) {
    spans.push_back({at, at + static_cast<float>(count) * step, step});
    at = spans.back().x1 + between;
  }
  return spans;
}

}  // namespace taxel::ui
