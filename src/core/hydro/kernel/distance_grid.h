// How far is it at least to the nearest tetrahedron, and which one is near? Answers by one look-up.
#pragma once

#include <cstdint>
#include <vector>

#include "core/hydro/pressure_field.h"

namespace taxel {

class DistanceGrid {
 public:
  struct Cell {
    float distance = 0;     ///< every point of the cell is at least this far from every tet [m]; 0 in cells with tets
    std::int32_t tet = -1;  ///< one that meets the cell, that of its middle where there is one; -1 where none does
  };

  DistanceGrid() = default;
  explicit DistanceGrid(const PressureField& field);

  /// Bounds of the field, enlarged a little.
  [[nodiscard]] const dvec3& low() const { return low_; }
  [[nodiscard]] const ivec3& dims() const { return dims_; }
  [[nodiscard]] double cells_per_metre() const { return per_metre_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }  ///< x runs fastest

  /// The cell of a point; of the nearest point of the grid, for one outside of it.
  [[nodiscard]] const Cell& cell_of(const dvec3& p) const {
    const dvec3 r = glm::clamp((p - low_) * per_metre_, dvec3(0), dvec3(dims_ - 1));
    return cells_[index(static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.z))];
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + dims_.x * (y + dims_.y * z));
  }
  void mark(const PressureField& field);
  void spread(const std::vector<char>& marked);

  dvec3 low_{0};
  ivec3 dims_{0};
  double edge_ = 1, per_metre_ = 1;  ///< of a cell, and its inverse
  std::vector<Cell> cells_;
};

}  // namespace taxel
