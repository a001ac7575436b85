#include "core/layout/generators/grid.h"

#include <fmt/format.h>

namespace taxel {
namespace {

void check_grid(const Grid& grid) {
  require_count("grid", "rows", grid.rows);
  require_count("grid", "columns", grid.columns);
  if (grid.rows > kMaxGeneratedTaxels / grid.columns)
    throw Error("grid", "rows",
                fmt::format("{} x {} columns are more than {} taxels", grid.rows, grid.columns, kMaxGeneratedTaxels));
  require_positive("grid", "row_pitch", grid.row_pitch);
  require_positive("grid", "column_pitch", grid.column_pitch);
  require_positive("grid", "radius", grid.radius);
  require_finite("grid", "center", grid.center);
}

}  // namespace

std::vector<Taxel> planar_grid(const Grid& grid) {
  check_grid(grid);
  const dvec3 normal = require_direction("grid", "normal", grid.normal);
  const dvec3 along = require_direction("grid", "along_row", grid.along_row);
  const dvec3 in_plane = along - glm::dot(along, normal) * normal;
  const double parallel = 1e-6;  // sine of the smallest angle that defines a direction in the plane
  if (glm::length(in_plane) < parallel) throw Error("grid", "along_row", "must not be parallel to normal");
  const dvec3 to_column = glm::normalize(in_plane), to_row = glm::cross(normal, to_column);
  std::vector<Taxel> taxels;
  taxels.reserve(static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      Taxel taxel;
      taxel.id = row * grid.columns + column;
      taxel.name = fmt::format("row {} column {}", row, column);
      taxel.center = grid.center + (row - 0.5 * (grid.rows - 1)) * grid.row_pitch * to_row +
                     (column - 0.5 * (grid.columns - 1)) * grid.column_pitch * to_column;
      taxel.normal = normal;
      taxel.radius = grid.radius;
      taxels.push_back(taxel);
    }
  }
  return taxels;
}

std::vector<Taxel> curved_grid(const Grid& grid, const dvec3& direction, const MeshIndex& skin, Beyond beyond) {
  const dvec3 along = require_direction("curved grid", "direction", direction);
  std::vector<Taxel> taxels;
  for (const Taxel& flat : planar_grid(grid)) {
    const auto at = skin_under(skin, flat.center, along, beyond, "curved grid", flat.name);
    if (!at) continue;
    taxels.push_back(taxel_on(skin.mesh(), *at, flat.id, flat.radius));
    taxels.back().name = flat.name;
  }
  require_some("curved grid", taxels);
  return taxels;
}

}  // namespace taxel
