#include "core/sensor/cast_rays.h"

#include <tuple>

namespace taxel {
namespace {

/// A box that a few roundings cannot shrink: the slab test and the triangle test compute the same distance in two ways,
/// so the box of a flat polygon grows by some units in the last place of the coordinates involved.
Aabb widened(const Aabb& box, double scale) {
  const double margin = 64.0 * std::numeric_limits<double>::epsilon() * scale;
  return {box.lo - margin, box.hi + margin};
}

double largest_coordinate(const Aabb& box) {
  const dvec3 m = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  return std::max({m.x, m.y, m.z});
}

Aabb polygon_box(const ContactSurface& surface, const ContactPolygon& polygon) {
  Aabb box;
  for (int i = 0; i < polygon.count; ++i) box.include(surface.vertices[static_cast<std::size_t>(polygon.first + i)]);
  return box;
}

}  // namespace

RayHit nearer_hit(const RayTriangleTest& ray, double max_depth, const ContactSurface& surface, int surface_number,
                  int polygon, const RayHit& best) {
  const ContactPolygon& p = surface.polygons[static_cast<std::size_t>(polygon)];
  RayHit nearest = best;
  const auto a = static_cast<std::size_t>(p.first);
  for (int i = 1; i + 1 < p.count; ++i) {
    const auto b = a + static_cast<std::size_t>(i), c = b + 1;
    const auto hit = ray(surface.vertices[a], surface.vertices[b], surface.vertices[c], max_depth);
    if (!hit) continue;
    const bool wins = !nearest.hit() || std::tuple(hit->t, surface_number, polygon) <
                                            std::tuple(nearest.depth, nearest.surface, nearest.polygon);
    if (!wins) continue;
    const dvec3 corners(surface.pressure[a], surface.pressure[b], surface.pressure[c]);
    nearest = {surface_number, polygon, hit->t, glm::dot(hit->barycentric, corners)};
  }
  return nearest;
}

void SurfaceCaster::build_blas(std::size_t number) {
  polygon_boxes_.clear();
  Aabb box;
  if (const ContactSurface* surface = surfaces_[number]) {
    for (const ContactPolygon& polygon : surface->polygons) {
      polygon_boxes_.push_back(polygon_box(*surface, polygon));
      box.include(polygon_boxes_.back());
    }
    for (Aabb& b : polygon_boxes_) b = widened(b, largest_coordinate(box));
  }
  blas_[number].build(polygon_boxes_);
  if (!blas_[number].empty()) bounds_.include(blas_[number].nodes()[0].box);
}

void SurfaceCaster::build(std::span<const ContactSurface* const> surfaces) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  if (blas_.size() < surfaces_.size()) blas_.resize(surfaces_.size());
  bounds_ = Aabb{};
  trees_.clear();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    build_blas(i);
    trees_.push_back(&blas_[i]);
  }
  tlas_.build(trees_);
}

RayHit SurfaceCaster::cast(const dvec3& origin, const dvec3& direction, double max_depth) const {
  RayHit best;
  const Ray ray{origin, direction, max_depth};
  const RayTriangleTest test(ray);
  tlas_.cast(ray, [&](int surface, int polygon, double reach) {
    best = nearer_hit(test, reach, *surfaces_[static_cast<std::size_t>(surface)], surface, polygon, best);
    return best.hit() ? best.depth : reach;
  });
  return best;
}

void cast_rays(const SensorModel& model, const SurfaceCaster& caster, std::vector<RayHit>& hits) {
  hits.assign(model.rays.size(), RayHit{});
  const Aabb bounds = caster.bounds();
  if (bounds.empty()) return;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const SensorRay& ray = model.rays[i];
    const dvec3 end = ray.origin + ray.max_depth * ray.direction;
    const Aabb segment{glm::min(ray.origin, end), glm::max(ray.origin, end)};
    if (segment.overlaps(bounds)) hits[i] = caster.cast(ray.origin, ray.direction, ray.max_depth);
  }
}

}  // namespace taxel
