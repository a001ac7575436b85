// A grid that gives, by one look-up, a lower bound of the distance of a point to the nearest tetrahedron, and a
// tetrahedron near the point.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

class DistanceGrid {
 public:
  /// Value of Cell::tet for cells without tets inside the skin (mark_core).
  static constexpr std::int32_t kCoreCell = -2;
  struct Cell {
    /// Lower bound of the distance from every point of the cell to the tets [m]. It is 0 in cells with tets, and in
    /// cells inside of the skin without tets, where depth pieces are used (mark_core).
    float distance = 0;
    std::int32_t tet = -1;   ///< a tet that touches the cell (of its middle if any); -1 or kCoreCell if none
    std::int32_t face = -1;  ///< index in faces(): the plane from which the cell is farthest outside, or -1
  };
  /// The plane of a boundary face of a convex field: the whole field is at n . x + offset >= 0, up to rounding.
  struct Face {
    dvec3 n{0};  ///< inward unit normal
    double offset = 0;
    std::int32_t tet = -1, side = -1;            ///< tet, and the index of its face
    std::array<std::int32_t, 3> neighbours{{}};  ///< faces across the three edges
  };

  DistanceGrid() = default;
  explicit DistanceGrid(const PressureField& field);
  /// Finds the cells without tets that are inside the closed skin or are crossed by it, and sets their distance to 0.
  /// Also finds the gaps of the field below the skin.
  void mark_core(const PressureField& field, const TriMesh& skin);

  /// Returns the lower corner of the grid, which covers slightly more than the bounds of the field.
  [[nodiscard]] const dvec3& low() const { return low_; }
  [[nodiscard]] const ivec3& dims() const { return dims_; }
  [[nodiscard]] double cells_per_metre() const { return per_metre_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }  ///< all cells; x is the fastest index
  /// Returns the whole boundary of a convex field; empty for other fields.
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  void set_faces(std::vector<Face> faces);

  /// Returns the cell of a point, or, for a point outside of the grid, the cell of the nearest point of the grid.
  [[nodiscard]] const Cell& cell_of(const dvec3& p) const {
    const dvec3 r = glm::clamp((p - low_) * per_metre_, dvec3(0), dvec3(dims_ - 1));
    return cells_[index(static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.z))];
  }

  /// Returns true if the skin crosses the cell of a point and the cell may contain a part of the body without tets.
  /// False before mark_core().
  [[nodiscard]] bool may_hold_gap(const dvec3& p) const {
    return !gaps_.empty() && gaps_[static_cast<std::size_t>(&cell_of(p) - cells_.data())] == kGap;
  }
  /// Returns true if this may be so at some point of a box. It is true for a box of very many cells.
  [[nodiscard]] bool may_hold_gap(const Aabb& box) const;

 private:
  static constexpr std::uint8_t kSkin = 1, kNearCore = 2, kGap = kSkin | kNearCore;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + dims_.x * (y + dims_.y * z));
  }
  void mark(const PressureField& field);
  void spread(const std::vector<char>& marked);
  void mark_gaps(const PressureField& field, const TriMesh& skin);
  void mark_triangle(const std::array<dvec3, 3>& corners, double margin, std::uint8_t bit);

  dvec3 low_{0};
  ivec3 dims_{0};
  double edge_ = 1, per_metre_ = 1;  ///< edge of a cell [m], and its inverse
  std::vector<Cell> cells_;
  std::vector<Face> faces_;
  std::vector<std::uint8_t> gaps_;  ///< bits kSkin, kNearCore of each cell; empty if the field ends with its tets
};

}  // namespace taxel
