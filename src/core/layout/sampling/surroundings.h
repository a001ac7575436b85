// The points around a cell of a surface, and a search for points near a place.
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

/// A place on a surface in single precision, in units of a spacing from some origin near to it.
struct NearPlace {
  float position[3]{}, normal[3]{};
};

/// The points near to one place, in the order in which they were gathered.
struct NearPoints {
  std::vector<int> rank;
  std::vector<float> x, y, z;  ///< from the place to the point
  std::vector<float> distance;
  std::vector<float> cosine;  ///< cosine between the normals; kOffPatch if no straight line gives the distance
  int count = 0;              ///< the vectors are longer
  static constexpr float kOffPatch = -2.0F;

  [[nodiscard]] bool on_patch(std::size_t i) const { return cosine[i] != kOffPatch; }
};

/// Points and their normals, coordinate by coordinate, followed by places far away that fill the last lanes.
struct PointRows {
  std::vector<int> rank;
  std::vector<float> x, y, z, normal_x, normal_y, normal_z;  ///< may be longer
  std::size_t size = 0;                                      ///< with the filling
};

/// Positions and normals of the points in and around one cell of a CellList. One per thread: it keeps its memory.
class Surroundings {
 public:
  /// `positions` and `normals` by rank. `spacing` is the unit of length here [m].
  void gather(const CellList& cells, int cell, std::span<const dvec3> positions, std::span<const dvec3> normals,
              double spacing);
  /// In the units of this cell.
  [[nodiscard]] NearPlace place(const dvec3& position, const dvec3& normal) const;
  /// A point of the cell itself has moved.
  void move(std::uint32_t rank, const NearPlace& to);

  /// All points within `reach` spacings, except the one of number `except`: in lanes of the best instruction set of the
  /// machine, with the same bits on each. A point is on one patch with the place if the straight line between them
  /// stands for their distance along the surface: it bends by at most a right angle between them, and does not rise by
  /// more than 30 degrees and that bend. Not so over a sharper edge, through a thin wall, or from sheet to sheet.
  void find_near(const NearPlace& place, float reach, std::uint32_t except, NearPoints& near) const;

 private:
  void put(std::size_t at, int rank, const NearPlace& p);

  dvec3 origin_{0};
  double spacing_ = 1.0;
  std::uint32_t first_own_ = 0;  // rank of the cell's first point
  std::size_t own_ = 0;          // index of the sample itself
  PointRows rows_;
};

}  // namespace taxel
