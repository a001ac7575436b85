#include "core/layout/field/point_grid.h"

#include <bit>

namespace taxel {
namespace {
// Cell numbers stay within +-2^40, far from the limits of 64 bits, however small the cells are.
constexpr double kMaxCell = 0x1.0p40;
}  // namespace

PointGrid::Cell PointGrid::cell_of(const dvec3& p) const {
  const dvec3 c = glm::clamp(glm::floor((p - origin_) / cell_), dvec3(-kMaxCell), dvec3(kMaxCell));
  return {static_cast<std::int64_t>(c.x), static_cast<std::int64_t>(c.y), static_cast<std::int64_t>(c.z)};
}

PointGrid::PointGrid(std::span<const dvec3> points, double cell) : cell_(cell) {
  Aabb box;
  for (const dvec3& p : points) box.include(p);
  if (!box.empty()) origin_ = box.lo;
  mask_ = std::bit_ceil(std::max<std::size_t>(points.size(), 1)) - 1;

  // Counting sort by bucket; points keep their order within one.
  std::vector<Item> unsorted(points.size());
  first_.assign(mask_ + 2, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    unsorted[i] = {cell_of(points[i]), static_cast<int>(i)};
    ++first_[bucket_of(unsorted[i].cell) + 1];
  }
  for (std::size_t b = 0; b <= mask_; ++b) first_[b + 1] += first_[b];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  items_.resize(points.size());
  for (const Item& item : unsorted) items_[next[bucket_of(item.cell)]++] = item;
}

}  // namespace taxel
