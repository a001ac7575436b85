// Grids, rings, helices and sunflower spirals.

#include "core/layout/generators/arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/layout/generators/place.h"

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

namespace {

/// The rows of a lattice that cover the view of a mesh along -normal.
struct LatticeRange {
  dvec3 right, up;        ///< unit vectors along the rows and across them
  dvec2 low{0}, high{0};  ///< bounds of the mesh from the centre, along these [m]
  double top = 0;         ///< height above the centre that is outside of the mesh [m]
};

LatticeRange lattice_range(const HexagonalCover& cover, const dvec3& normal, const TriMesh& mesh) {
  const dvec3 along = require_direction("hexagonal", "along_row", cover.along_row);
  const dvec3 in_plane = along - glm::dot(along, normal) * normal;
  const double parallel = 1e-6;  // sine of the smallest angle that defines a direction in the plane
  if (glm::length(in_plane) < parallel) throw Error("hexagonal", "along_row", "must not be parallel to normal");
  LatticeRange range;
  range.right = glm::normalize(in_plane);
  range.up = glm::cross(normal, range.right);
  range.top = 2 * mesh.bounds().diagonal();
  for (const dvec3& vertex : mesh.vertices()) {
    const dvec3 d = vertex - cover.center;
    const dvec2 seen(glm::dot(d, range.right), glm::dot(d, range.up));
    range.low = glm::min(range.low, seen);
    range.high = glm::max(range.high, seen);
    range.top = std::max(range.top, 2 * glm::dot(d, normal));
  }
  return range;
}

}  // namespace

std::vector<Taxel> hexagonal_cover(const HexagonalCover& cover, const MeshIndex& skin) {
  require_positive("hexagonal", "pitch", cover.pitch);
  require_positive("hexagonal", "radius", cover.radius);
  require_finite("hexagonal", "center", cover.center);
  const dvec3 normal = require_direction("hexagonal", "normal", cover.normal);
  const LatticeRange range = lattice_range(cover, normal, skin.mesh());
  const double row_pitch = cover.pitch * std::sqrt(3.0) / 2;
  const dvec2 size = range.high - range.low;
  if ((size.x / cover.pitch + 2) * (size.y / row_pitch + 2) > kMaxGeneratedTaxels)
    throw Error("hexagonal", "pitch",
                fmt::format("{} m gives more than {} points over a mesh of {:.3g} x {:.3g} m", cover.pitch,
                            kMaxGeneratedTaxels, size.x, size.y));
  const double least_cosine = std::cos(cover.max_slope_deg * kPi / 180);
  std::vector<Taxel> taxels;
  const int first_row = static_cast<int>(std::ceil(range.low.y / row_pitch));
  const int last_row = static_cast<int>(std::floor(range.high.y / row_pitch));
  for (int row = first_row; row <= last_row; ++row) {
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    const int first = static_cast<int>(std::ceil(range.low.x / cover.pitch - shift));
    const int last = static_cast<int>(std::floor(range.high.x / cover.pitch - shift));
    for (int column = first; column <= last; ++column) {
      const dvec3 origin =
          cover.center + range.top * normal + row * row_pitch * range.up + (column + shift) * cover.pitch * range.right;
      const auto at = skin_under(skin, origin, -normal, Beyond::leave_out, "hexagonal", "");
      if (!at || (!cover.faces.empty() && !std::binary_search(cover.faces.begin(), cover.faces.end(), at->face)))
        continue;
      if (glm::dot(smooth_normal(skin.mesh(), *at), normal) < least_cosine) continue;
      taxels.push_back(taxel_on(skin.mesh(), *at, static_cast<int>(taxels.size()), cover.radius));
    }
  }
  require_some("hexagonal", taxels);
  return taxels;
}

namespace {

/// Rays from outside of the mesh toward an axis.
class Inward {
 public:
  Inward(const AroundAxis& around, const MeshIndex& skin, std::string generator)
      : around_(around), skin_(skin), generator_(std::move(generator)) {
    require_count(generator_, "count", around.count);
    require_positive(generator_, "radius", around.radius);
    require_finite(generator_, "origin", around.origin);
    axis_ = require_direction(generator_, "axis", around.axis);
    const dvec3 first = require_direction(generator_, "first", around.first);
    const dvec3 across = first - glm::dot(first, axis_) * axis_;
    const double parallel = 1e-6;  // sine of the smallest angle that defines a half plane
    if (glm::length(across) < parallel) throw Error(generator_, "first", "must not be parallel to axis");
    zero_ = glm::normalize(across);
    quarter_ = glm::cross(axis_, zero_);
  }

  [[nodiscard]] Taxel at(int id, double height, double angle) const {
    const dvec3 out = std::cos(angle) * zero_ + std::sin(angle) * quarter_;
    const dvec3 foot = around_.origin + height * axis_;
    const Aabb& box = skin_.mesh().bounds();
    const double outside = glm::distance(foot, box.center()) + box.diagonal();
    SurfacePoint hit =
        *skin_under(skin_, foot + outside * out, -out, Beyond::refuse, generator_, fmt::format("taxel {}", id));
    if (glm::dot(hit.position - foot, out) < 0.0)
      throw Error(generator_, fmt::format("taxel {}", id),
                  fmt::format("the ray toward the axis at height {:.6g} meets the mesh only beyond the axis", height));
    return taxel_on(skin_.mesh(), hit, id, around_.radius);
  }

 private:
  const AroundAxis& around_;
  const MeshIndex& skin_;
  std::string generator_;
  dvec3 axis_{0}, zero_{0}, quarter_{0};
};

}  // namespace

std::vector<Taxel> ring(const AroundAxis& around, double height, const MeshIndex& skin) {
  const Inward inward(around, skin, "ring");
  require_finite("ring", "height", height);
  std::vector<Taxel> taxels;
  for (int i = 0; i < around.count; ++i) taxels.push_back(inward.at(i, height, 2.0 * kPi * i / around.count));
  return taxels;
}

std::vector<Taxel> helix(const AroundAxis& around, double bottom, double top, double turns, const MeshIndex& skin) {
  const Inward inward(around, skin, "helix");
  if (around.count < 2) throw Error("helix", "count", fmt::format("must be at least 2, is {}", around.count));
  require_finite("helix", "bottom", bottom);
  require_finite("helix", "top", top);
  require_finite("helix", "turns", turns);
  if (turns == 0.0) throw Error("helix", "turns", "must not be 0");
  std::vector<Taxel> taxels;
  for (int i = 0; i < around.count; ++i) {
    const double t = static_cast<double>(i) / (around.count - 1);
    taxels.push_back(inward.at(i, bottom + t * (top - bottom), 2.0 * kPi * turns * t));
  }
  return taxels;
}

std::vector<Taxel> sunflower(const Spiral& spiral, const MeshIndex& skin, Beyond beyond) {
  require_count("spiral", "count", spiral.count);
  require_finite("spiral", "center", spiral.center);
  require_positive("spiral", "disc_radius", spiral.disc_radius);
  require_positive("spiral", "radius", spiral.radius);
  const dvec3 direction = require_direction("spiral", "direction", spiral.direction);
  const dvec3 zero = any_perpendicular(direction), quarter = glm::cross(-direction, zero);
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  std::vector<Taxel> taxels;
  for (int k = 0; k < spiral.count; ++k) {
    const double r = spiral.disc_radius * std::sqrt((k + 0.5) / spiral.count), theta = k * golden_angle;
    const dvec3 start = spiral.center + r * (std::cos(theta) * zero + std::sin(theta) * quarter);
    const auto at = skin_under(skin, start, direction, beyond, "spiral", fmt::format("taxel {}", k));
    if (at) taxels.push_back(taxel_on(skin.mesh(), *at, k, spiral.radius));
  }
  require_some("spiral", taxels);
  return taxels;
}

}  // namespace taxel
