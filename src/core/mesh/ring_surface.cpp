#include "core/mesh/ring_surface.h"

namespace taxel {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

void RingSurface::add_ring(const std::vector<dvec3>& ring) {
  const int low = first_, low_count = count_;
  const int high = static_cast<int>(vertices_.size()), high_count = static_cast<int>(ring.size());
  vertices_.insert(vertices_.end(), ring.begin(), ring.end());
  first_ = high;
  count_ = high_count;
  if (low_count == 0) return;
  // Walk around both rings at once; advance on the one whose step leaves the shorter diagonal, by its fraction of the
  // turn when both rings have points left.
  const auto lower = [&](int i) { return low + i % low_count; };
  const auto upper = [&](int i) { return high + i % high_count; };
  const int low_steps = low_count > 1 ? low_count : 0, high_steps = high_count > 1 ? high_count : 0;
  int i = 0, j = 0;
  while (i < low_steps || j < high_steps) {
    bool advance_low = j >= high_steps;
    if (i < low_steps && j < high_steps) {
      const double with_low = glm::distance(vertices_[at(lower(i + 1))], vertices_[at(upper(j))]);
      const double with_high = glm::distance(vertices_[at(lower(i))], vertices_[at(upper(j + 1))]);
      advance_low = with_low < with_high;
    }
    if (advance_low) {
      faces_.emplace_back(lower(i), lower(i + 1), upper(j));
      ++i;
    } else {
      faces_.emplace_back(lower(i), upper(j + 1), upper(j));
      ++j;
    }
  }
}

}  // namespace taxel
