// Points sorted by the cells of a uniform grid, for passes over all points and their neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Occupied cells only, found by hashing: memory is O(points), whatever the extent. PointGrid answers single queries;
/// here the neighbours of a whole cell are gathered at once.
class CellList {
 public:
  /// `cell` > 0 is the edge of a cell [m].
  CellList(std::span<const dvec3> points, double cell);

  [[nodiscard]] int cell_count() const { return static_cast<int>(cells_.size()); }
  /// Numbers of the points in a cell, ascending.
  [[nodiscard]] std::span<const int> points_in(int cell) const {
    const Cell& c = cells_[static_cast<std::size_t>(cell)];
    return std::span<const int>(points_).subspan(c.first, c.count);
  }
  /// Cells of one of eight colours never touch each other.
  [[nodiscard]] int colour(int cell) const;
  /// Replaces `near` by the points of the cell and of the 26 around it: all within one edge length of any point of it,
  /// and some more.
  void gather(int cell, std::vector<int>& near) const;

 private:
  using Key = std::uint64_t;  // 21 bits for each coordinate
  struct Cell {
    Key key = 0;
    std::uint32_t first = 0, count = 0;
  };
  [[nodiscard]] int find(Key key) const;

  std::vector<Cell> cells_;  // by key
  std::vector<int> points_;
  std::vector<int> table_;  // open addressing: numbers of cells, -1 where empty
};

}  // namespace taxel
