// A hashed uniform grid over points, which finds all points within a radius in time proportional to their number.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/base/rng.h"

namespace taxel {

/// Points sorted by hashed grid cell (Teschner et al. 2003). Immutable after build; memory is O(points), whatever the
/// extent of the scene, because a surface fills only few of the cells of its box.
class PointGrid {
 public:
  /// `cell` > 0 is the edge of a cell [m]. It should be close to the radius of the queries.
  PointGrid(std::span<const dvec3> points, double cell);

  /// Calls visit(i) for every point whose cell intersects the box of the ball: a superset of the points within
  /// `radius`. The order depends only on the points and the cell size.
  template <class Visit>
  void visit_near(const dvec3& center, double radius, const Visit& visit) const {
    const Cell lo = cell_of(center - radius), hi = cell_of(center + radius);
    const double cells = (double(hi.x - lo.x) + 1) * (double(hi.y - lo.y) + 1) * (double(hi.z - lo.z) + 1);
    if (cells > double(items_.size())) {  // for a ball with many empty cells, visiting all points is cheaper
      for (const Item& item : items_) visit(item.point);
      return;
    }
    Cell c = lo;
    for (c.z = lo.z; c.z <= hi.z; ++c.z)
      for (c.y = lo.y; c.y <= hi.y; ++c.y)
        for (c.x = lo.x; c.x <= hi.x; ++c.x) visit_cell(c, visit);
  }

 private:
  struct Cell {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const Cell&) const = default;
  };
  struct Item {
    Cell cell;
    int point = 0;
  };

  [[nodiscard]] Cell cell_of(const dvec3& p) const;
  [[nodiscard]] std::size_t bucket_of(const Cell& c) const {
    const std::uint64_t key = mix64(static_cast<std::uint64_t>(c.x) ^
                                    mix64(static_cast<std::uint64_t>(c.y) ^ mix64(static_cast<std::uint64_t>(c.z))));
    return static_cast<std::size_t>(key) & mask_;
  }
  template <class Visit>
  void visit_cell(const Cell& c, const Visit& visit) const {
    const std::size_t bucket = bucket_of(c);
    for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i)
      if (items_[i].cell == c) visit(items_[i].point);
  }

  dvec3 origin_{0};
  double cell_ = 1.0;
  std::size_t mask_ = 0;            // number of buckets (a power of two) minus one
  std::vector<std::size_t> first_;  // bucket b holds items [first_[b], first_[b + 1])
  std::vector<Item> items_;
};

}  // namespace taxel
