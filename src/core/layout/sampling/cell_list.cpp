#include "core/layout/sampling/cell_list.h"

#include <bit>

#include "core/base/rng.h"

namespace taxel {
namespace {

constexpr int kBits = 21;
constexpr std::uint64_t kLargest = (1U << kBits) - 1;  // of a coordinate; farther points share the last cells

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
    if (cells_.empty() || cells_.back().key != key)
      cells_.push_back({key, static_cast<std::uint32_t>(points_.size()), 0});
    ++cells_.back().count;
    points_.push_back(point);
  }
  table_.assign(std::bit_ceil(2 * cells_.size() + 1), -1);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    std::size_t at = mix64(cells_[c].key) & (table_.size() - 1);
    while (table_[at] >= 0) at = (at + 1) & (table_.size() - 1);
    table_[at] = static_cast<int>(c);
  }
}

int CellList::find(Key key) const {
  for (std::size_t at = mix64(key) & (table_.size() - 1); table_[at] >= 0; at = (at + 1) & (table_.size() - 1))
    if (cells_[static_cast<std::size_t>(table_[at])].key == key) return table_[at];
  return -1;
}

int CellList::colour(int cell) const {
  const auto [x, y, z] = unpack(cells_[static_cast<std::size_t>(cell)].key);
  return static_cast<int>((x & 1) | (y & 1) << 1 | (z & 1) << 2);
}

void CellList::gather(int cell, std::vector<int>& near) const {
  near.clear();
  const auto [x, y, z] = unpack(cells_[static_cast<std::size_t>(cell)].key);
  const auto from = [](std::uint64_t c) { return c > 0 ? c - 1 : 0; };
  const auto to = [](std::uint64_t c) { return std::min(c + 1, kLargest); };
  for (std::uint64_t k = from(z); k <= to(z); ++k)
    for (std::uint64_t j = from(y); j <= to(y); ++j)
      for (std::uint64_t i = from(x); i <= to(x); ++i) {
        const int found = find(pack(i, j, k));
        if (found < 0) continue;
        const auto points = points_in(found);
        near.insert(near.end(), points.begin(), points.end());
      }
}

}  // namespace taxel
