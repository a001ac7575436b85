// Points sorted by the cells of a uniform grid, for passes over all points and their neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// The occupied cells in the order of their keys. Memory is O(points), whatever the extent. While PointGrid is for
/// single queries, this class gives the neighbours of a whole cell at once, as nine rows of successive cells.
class CellList {
 public:
  /// `cell` > 0 is the edge of a cell [m].
  CellList(std::span<const dvec3> points, double cell);

  [[nodiscard]] int cell_count() const { return static_cast<int>(cells_.size()); }
  /// Returns the indices of all points, cell by cell and ascending within a cell. A position in this list is called a
  /// rank.
  [[nodiscard]] const std::vector<int>& points() const { return points_; }

  struct Ranks {
    std::uint32_t begin = 0, end = 0;
  };
  [[nodiscard]] Ranks ranks_in(int cell) const { return cells_[static_cast<std::size_t>(cell)].ranks; }
  [[nodiscard]] std::span<const int> points_in(int cell) const {
    const Ranks r = ranks_in(cell);
    return std::span<const int>(points_).subspan(r.begin, r.end - r.begin);
  }
  /// Returns the ranks of the points in a cell and the 26 cells around it: all points within one edge length of any
  /// point of the cell, and some more. The middle row has the cell itself.
  [[nodiscard]] const std::array<Ranks, 9>& ranks_around(int cell) const {
    return cells_[static_cast<std::size_t>(cell)].around;
  }
  /// Returns one of eight colours. Cells of the same colour never touch each other.
  [[nodiscard]] int colour(int cell) const;

 private:
  using Key = std::uint64_t;  // 21 bits for each coordinate, the x coordinate lowest
  struct Cell {
    Key key = 0;
    Ranks ranks;
    std::array<Ranks, 9> around;  // by y, then z, from below to above
  };
  void find_row(int dy, int dz);

  std::vector<Cell> cells_;  // by key
  std::vector<int> points_;
};

}  // namespace taxel
