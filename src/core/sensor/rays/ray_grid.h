// The rays of a flat array, which all have one direction, sorted once into the cells of a grid across that direction.
// Only the rays under the projection of a contact polygon can hit it: the polygon is drawn into the grid row by row, as
// a rasteriser draws a polygon into pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

/// The grid.
class RayGrid {
 public:
  /// Returns null if there are no rays, or if their directions differ by more than 1e-9, which is more than the normals
  /// of the faces of one plane differ.
  static std::shared_ptr<const RayGrid> make(std::span<const SensorRay> rays);

  /// The positions of the rays across the grid [m], in single precision, and their indices in SensorModel::rays. Sorted
  /// by row, column and index, with kRoom places of padding at the end.
  [[nodiscard]] const float* x() const { return x_.data(); }
  [[nodiscard]] const float* y() const { return y_.data(); }
  [[nodiscard]] const std::int32_t* rays() const { return rays_.data(); }
  static constexpr std::size_t kRoom = 16;
  /// The view along the rays, whose u and v are x and y of the grid. No ray has a slope in this view.
  [[nodiscard]] const RayView& view() const { return view_; }

  /// Calls visit(first, last) for ranges of places that include all rays which may hit the polygon.
  template <class Visit>
  void visit(const ContactSurface& surface, const ContactPolygon& polygon, const Visit& visit) const {
    const Cells cells = cells_under(surface, polygon);
    for (std::size_t row = cells.row_first; row < cells.row_last; ++row) {
      const std::size_t start = row * columns_;
      const std::int32_t first = first_[start + cells.column_first], last = first_[start + cells.column_last];
      if (first < last) visit(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
    }
  }

  [[nodiscard]] std::size_t cell_count() const { return rows_ * columns_; }

 private:
  /// Half-open ranges of rows and columns. Empty if the polygon is outside of the grid or out of reach of the rays.
  struct Cells {
    std::size_t row_first = 0, row_last = 0, column_first = 0, column_last = 0;
  };
  explicit RayGrid(std::span<const SensorRay> rays, const dvec3& direction);
  [[nodiscard]] Cells cells_under(const ContactSurface& surface, const ContactPolygon& polygon) const;
  [[nodiscard]] std::size_t row_of(double y) const { return cell_of((y - reach_.lo.y) * per_cell_, rows_); }
  [[nodiscard]] std::size_t column_of(double x) const { return cell_of((x - reach_.lo.x) * per_cell_, columns_); }
  static std::size_t cell_of(double cells, std::size_t count) {
    return cells > 0.0 ? std::min(static_cast<std::size_t>(std::min(cells, 1e9)), count - 1) : 0;
  }

  dmat3 axes_{1.0};      // p_grid = p_M * axes_; the third one along the rays
  Aabb reach_;           // box of the rays from origin to depth, in these axes
  double slack_ = 0;     // distance by which rays leave their cell, and rounding of coordinates [m]
  double per_cell_ = 1;  // 1 / edge of a cell [1/m]
  std::size_t rows_ = 1, columns_ = 1;
  std::vector<std::int32_t> first_;  // first place of each cell in row order, and the end
  std::vector<float> x_, y_;
  std::vector<std::int32_t> rays_;
  RayView view_;
};

/// Offers the hits of all rays of the grid on one surface of any origin.
void cast_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits);

}  // namespace taxel
