// The rays of a flat array: all of one direction, binned once in a grid across it. A contact polygon can meet only the
// rays under its projection, so that it is drawn into the grid row by row, as a rasteriser draws it into pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/cast_buffers.h"
#include "core/sensor/rays/ray_hits.h"
#include "core/sensor/rays/ray_view.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

class RayGrid {
 public:
  /// Null where the rays do not share one direction (to 1e-9, which the normals of one plane's faces keep), or there is
  /// none.
  static std::shared_ptr<const RayGrid> make(std::span<const SensorRay> rays);

  /// Where rays are across the grid [m], in single precision, and their numbers in SensorModel::rays: sorted by row,
  /// within a row by column, within a cell ascending. With kRoom places behind the last.
  [[nodiscard]] const float* x() const { return x_.data(); }
  [[nodiscard]] const float* y() const { return y_.data(); }
  [[nodiscard]] const std::int32_t* rays() const { return rays_.data(); }
  static constexpr std::size_t kRoom = 16;
  /// Along the rays, with the grid's x and y for u and v; no ray has a slope there.
  [[nodiscard]] const RayView& view() const { return view_; }

  /// Calls visit(first, last) for ranges of those places that hold every ray which may meet the polygon, and others.
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
  /// Half open ranges; empty where the polygon is beside the grid, or out of the rays' reach.
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
  Aabb reach_;           // of the rays, from origin to depth, in those axes
  double slack_ = 0;     // by what rays leave their cell on the way down, and by what coordinates are rounded [m]
  double per_cell_ = 1;  // 1 / edge of a cell [1/m]
  std::size_t rows_ = 1, columns_ = 1;
  std::vector<std::int32_t> first_;  // of each cell in row order, and the end
  std::vector<float> x_, y_;
  std::vector<std::int32_t> rays_;
  RayView view_;
};

/// Offers the hits of all rays (those of the grid) on one surface, wherever it comes from.
void cast_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits);

}  // namespace taxel
