// Rays on contact surfaces by two levels of trees, rebuilt in every step: for rigid sensors, and for polygons that are
// in no tet of the sensor, such as depth pieces.
//
// Each surface has a tree over its polygons (BLAS), in axes of its own whose third one is its mean normal, so that the
// boxes of a nearly flat patch are thin. A tree over the surfaces (TLAS) is visited first. Boxes are widened by the
// reach of a polygon beyond its rim and by the rounding of both frames, so that no box hides a hit. The first hit wins,
// at equal depth that on the lowest surface and polygon, so the result does not depend on the trees.
#include "core/sensor/rays/surface_caster.h"

#include "core/sensor/rays/tet_table.h"

namespace taxel {
namespace {

/// Returns the enlargement of boxes: the reach of a polygon beyond its rim (ray_target.h) for a perimeter within the
/// box, and some units in the last place of the coordinates, because distances to boxes are computed differently.
double margin_of(const Aabb& box) {
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi)), e = box.extent();
  const double coordinates = largest.x + largest.y + largest.z;
  return 2.0 * rim_reach(coordinates, 4.0 * (e.x + e.y + e.z)) +
         64.0 * std::numeric_limits<double>::epsilon() * coordinates;
}

Aabb widened(const Aabb& box, double margin) {
  return {box.lo - margin, box.hi + margin};
}

/// Returns axes as columns, the third one along the mean normal of the surface.
dmat3 patch_axes(const ContactSurface& surface) {
  dvec3 sum(0);
  for (const ContactPolygon& polygon : surface.polygons) sum += polygon.area * polygon.normal;
  const double length = glm::length(sum);
  if (!(length > 0.0)) return dmat3(1.0);
  const dvec3 normal = sum / length, u = any_perpendicular(normal);
  return {u, glm::cross(normal, u), normal};
}

}  // namespace

void SurfaceCaster::add_instance(std::size_t number, const TetTable* table) {
  const ContactSurface& surface = *surfaces_[number];
  Instance instance;
  instance.surface = static_cast<int>(number);
  for (const dvec3& v : surface.vertices) instance.box.include(v);
  const double margin = margin_of(instance.box);
  instance.box = widened(instance.box, margin);
  instance.axes = patch_axes(surface);

  boxes_.clear();
  polygons_[number].clear();
  planes_[number].resize(surface.vertices.size());
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    const ContactPolygon& polygon = surface.polygons[p];
    if (table != nullptr && table->has(polygon.tet)) continue;
    polygons_[number].push_back(static_cast<int>(p));
    fill_edge_planes(surface, polygon, planes_[number].data() + polygon.first);
    Aabb box;
    for (int i = 0; i < polygon.count; ++i)
      box.include(surface.vertices[static_cast<std::size_t>(polygon.first + i)] * instance.axes);
    boxes_.push_back(widened(box, margin));
  }
  if (boxes_.empty()) return;
  blas_[number].build(boxes_);
  instance.lo = blas_[number].nodes()[0].box.lo.z;
  instance.hi = blas_[number].nodes()[0].box.hi.z;
  instances_.push_back(instance);
}

void SurfaceCaster::build(std::span<const ContactSurface* const> surfaces, const TetTable* table) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  if (blas_.size() < surfaces_.size()) {
    blas_.resize(surfaces_.size());
    planes_.resize(surfaces_.size());
    polygons_.resize(surfaces_.size());
  }
  instances_.clear();
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i] && !surfaces_[i]->empty()) add_instance(i, table);
  boxes_.clear();
  for (const Instance& instance : instances_) boxes_.push_back(instance.box);
  tlas_.build(boxes_, 1);
}

std::size_t SurfaceCaster::node_count() const {
  std::size_t count = instances_.empty() ? 0 : tlas_.nodes().size();
  for (const Instance& instance : instances_) count += blas_[static_cast<std::size_t>(instance.surface)].nodes().size();
  return count;
}

bool SurfaceCaster::may_hit(const dvec3& from, const dvec3& to) const {
  const Aabb segment{glm::min(from, to), glm::max(from, to)};
  for (const Instance& instance : instances_) {
    if (!segment.overlaps(instance.box)) continue;
    const double a = glm::dot(instance.axes[2], from), b = glm::dot(instance.axes[2], to);
    if (std::min(a, b) <= instance.hi && std::max(a, b) >= instance.lo) return true;
  }
  return false;
}

RayHit SurfaceCaster::cast(const dvec3& origin, const dvec3& direction, double max_depth) const {
  RayHit best;
  const Ray ray{origin, direction, max_depth};
  tlas_.cast(ray, [&](int number, double t_max) {
    const Instance& instance = instances_[static_cast<std::size_t>(number)];
    const auto surface = static_cast<std::size_t>(instance.surface);
    const Ray turned{origin * instance.axes, direction * instance.axes, t_max};
    return blas_[surface].cast(turned, [&](int number_in_blas, double reach) {
      const int number_in_surface = polygons_[surface][static_cast<std::size_t>(number_in_blas)];
      const ContactPolygon& polygon = surfaces_[surface]->polygons[static_cast<std::size_t>(number_in_surface)];
      const auto found = hit_polygon(origin, direction, 0.0, reach, polygon, planes_[surface].data() + polygon.first);
      if (!found) return reach;
      const RayHit hit{instance.surface, number_in_surface, found->t, found->pressure};
      if (hit.before(best)) best = hit;
      return best.depth;
    });
  });
  return best;
}

}  // namespace taxel
