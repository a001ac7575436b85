#include "core/layout/sampling/cell_list.h"

namespace taxel {
namespace {

constexpr int kBits = 21;
constexpr std::uint64_t kLargest = (1U << kBits) - 1;  // largest coordinate; points farther away share the last cells

std::uint64_t pack(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x | (y << kBits) | (z << (2 * kBits));
}

std::array<std::uint64_t, 3> unpack(std::uint64_t key) {
  return {key & kLargest, (key >> kBits) & kLargest, key >> (2 * kBits)};
}

}  // namespace

CellList::CellList(std::span<const dvec3> points, double cell) {
  Aabb box;
  for (const dvec3& p : points) box.include(p);
  std::vector<std::pair<Key, int>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 c = glm::min((points[i] - box.lo) / cell, dvec3(static_cast<double>(kLargest)));
    sorted.emplace_back(pack(static_cast<Key>(c.x), static_cast<Key>(c.y), static_cast<Key>(c.z)), static_cast<int>(i));
  }
  std::sort(sorted.begin(), sorted.end());
  points_.reserve(points.size());
  for (const auto& [key, point] : sorted) {
    const auto rank = static_cast<std::uint32_t>(points_.size());
    if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, {rank, rank}, {}});
    cells_.back().ranks.end = rank + 1;
    points_.push_back(point);
  }
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) find_row(dy, dz);
}

/// Finds the row of up to three cells next to each cell. Both ends advance with the keys, so that one pass finds all.
void CellList::find_row(int dy, int dz) {
  const auto row = static_cast<std::size_t>(4 + dy + 3 * dz);
  std::size_t begin = 0, end = 0;
  const auto rank = [&](std::size_t c) {
    return c < cells_.size() ? cells_[c].ranks.begin : static_cast<std::uint32_t>(points_.size());
  };
  for (Cell& cell : cells_) {
    const auto [x, below_y, below_z] = unpack(cell.key);
    const Key y = below_y + static_cast<Key>(dy), z = below_z + static_cast<Key>(dz);  // -1 wraps to beyond the largest
    if (y > kLargest || z > kLargest) continue;
    const Key lo = pack(x > 0 ? x - 1 : 0, y, z), hi = pack(std::min(x + 1, kLargest), y, z);
    while (begin < cells_.size() && cells_[begin].key < lo) ++begin;
    end = std::max(begin, end);
    while (end < cells_.size() && cells_[end].key <= hi) ++end;
    cell.around[row] = {rank(begin), rank(end)};
  }
}

int CellList::colour(int cell) const {
  const auto [x, y, z] = unpack(cells_[static_cast<std::size_t>(cell)].key);
  return static_cast<int>((x & 1) | (y & 1) << 1 | (z & 1) << 2);
}

}  // namespace taxel
