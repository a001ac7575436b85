// The rays of a flat array in a grid across their common direction.
//
// Only rays under the projection of a polygon can hit it, so a polygon is drawn into the grid row by row, as a
// rasteriser fills pixels. The cells are square and hold two rays on average: larger cells would test more rays that
// are not below a polygon, smaller ones would visit empty rows. Rays are sorted into the cells by counting, so the rays
// of one row of cells are neighbours in memory and one polygon reads them in sequence.
//
// The box of a polygon is widened by the reach of its rim, the rounding of coordinates, and the drift of rays that are
// parallel only to 1e-9; a box that is too small would lose hits. Works for any surface, with tets or without. Theory:
// docs/theory/sensor.md, "Rays and readings".
#include "core/sensor/rays/ray_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taxel {
namespace {

/// Largest difference of equal directions.
constexpr double kParallel = 1e-9;
/// Average number of rays per cell if rays cover the whole grid. With larger cells polygons test more rays that are not
/// below them; with smaller cells polygons visit empty rows.
constexpr double kRaysPerCell = 2.0;

double l1(const dvec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace

std::shared_ptr<const RayGrid> RayGrid::make(std::span<const SensorRay> rays) {
  if (rays.empty()) return nullptr;
  const dvec3& direction = rays.front().direction;
  for (const SensorRay& ray : rays)
    if (!(l1(ray.direction - direction) <= kParallel)) return nullptr;
  return std::shared_ptr<const RayGrid>(new RayGrid(rays, direction));
}

RayGrid::RayGrid(std::span<const SensorRay> rays, const dvec3& direction) {
  const dvec3 u = any_perpendicular(direction);
  axes_ = dmat3(u, glm::cross(direction, u), direction);
  double largest = 0.0, deepest = 0.0;
  for (const SensorRay& ray : rays) {
    const dvec3 from = ray.origin * axes_;
    reach_.include(from);
    reach_.include(from + dvec3(0, 0, ray.max_depth));
    largest = std::max(largest, l1(ray.origin));
    deepest = std::max(deepest, ray.max_depth);
  }
  slack_ = kParallel * deepest + 64.0 * std::numeric_limits<double>::epsilon() * (largest + deepest);
  const dvec3 e = reach_.extent();
  const double count = static_cast<double>(rays.size());
  // Square cells. A line of rays has the same number of cells along the line.
  const double edge = std::max(std::sqrt(e.x * e.y * kRaysPerCell / count), (e.x + e.y) * kRaysPerCell / count);
  if (edge > 0.0 && std::isfinite(1.0 / edge)) {
    per_cell_ = 1.0 / edge;
    columns_ = static_cast<std::size_t>(e.x * per_cell_) + 1;
    rows_ = static_cast<std::size_t>(e.y * per_cell_) + 1;
  }

  std::vector<std::size_t> cell(rays.size());
  first_.assign(cell_count() + 1, 0);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const dvec3 p = rays[r].origin * axes_;
    cell[r] = row_of(p.y) * columns_ + column_of(p.x);
    ++first_[cell[r] + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  std::vector<std::int32_t> filling(first_.begin(), first_.end() - 1);
  rays_.assign(rays.size() + kRoom, -1);
  x_.assign(rays_.size(), 0.0F);
  y_.assign(rays_.size(), 0.0F);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const auto place = static_cast<std::size_t>(filling[cell[r]]++);
    const dvec3 p = rays[r].origin * axes_;
    rays_[place] = static_cast<std::int32_t>(r);
    x_[place] = static_cast<float>(p.x);
    y_[place] = static_cast<float>(p.y);
  }
  view_ = make_view(axes_[2], axes_[0], axes_[1], slack_ + kSingleRounding * (largest + deepest), 0.0);
}

RayGrid::Cells RayGrid::cells_under(const ContactSurface& surface, const ContactPolygon& polygon) const {
  Aabb box;
  for (int i = 0; i < polygon.count; ++i)
    box.include(surface.vertices[static_cast<std::size_t>(polygon.first + i)] * axes_);
  // The reach of a polygon beyond its rim (ray_target.h) and the rounding, doubled as a margin.
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  const double coordinates = l1(largest);
  const double margin = 2.0 * (slack_ + rim_reach(coordinates, polygon.count * l1(box.extent())) +
                               64.0 * std::numeric_limits<double>::epsilon() * coordinates);
  const dvec3 lo = box.lo - margin, hi = box.hi + margin;
  const bool apart = !(lo.x <= reach_.hi.x && hi.x >= reach_.lo.x && lo.y <= reach_.hi.y && hi.y >= reach_.lo.y &&
                       lo.z <= reach_.hi.z && hi.z >= reach_.lo.z);
  if (apart) return {};
  return {row_of(lo.y), row_of(hi.y) + 1, column_of(lo.x), column_of(hi.x) + 1};
}

}  // namespace taxel
