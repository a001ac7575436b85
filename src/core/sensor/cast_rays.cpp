#include "core/sensor/cast_rays.h"

#include <tuple>

#include "core/mesh/ray_triangle.h"

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

RayHit nearer_hit(const Ray& ray, const ContactSurface& surface, int surface_number, int polygon, const RayHit& best) {
  const ContactPolygon& p = surface.polygons[static_cast<std::size_t>(polygon)];
  RayHit nearest = best;
  const auto a = static_cast<std::size_t>(p.first);
  for (int i = 1; i + 1 < p.count; ++i) {
    const auto b = a + static_cast<std::size_t>(i), c = b + 1;
    const auto hit = intersect_triangle(ray, surface.vertices[a], surface.vertices[b], surface.vertices[c]);
    if (!hit) continue;
    const bool first = !nearest.hit() || std::tuple(hit->t, surface_number, polygon) <
                                             std::tuple(nearest.depth, nearest.surface, nearest.polygon);
    if (!first) continue;
    const dvec3 corners(surface.pressure[a], surface.pressure[b], surface.pressure[c]);
    nearest = {surface_number, polygon, hit->t, glm::dot(hit->barycentric, corners)};
  }
  return nearest;
}

void SurfaceCaster::build_blas(std::size_t number) {
  const ContactSurface& surface = *surfaces_[number];
  polygon_boxes_.clear();
  Aabb box;
  for (const ContactPolygon& polygon : surface.polygons) {
    polygon_boxes_.push_back(polygon_box(surface, polygon));
    box.include(polygon_boxes_.back());
  }
  const double scale = largest_coordinate(box);
  for (Aabb& b : polygon_boxes_) b = widened(b, scale);
  blas_[number].build(polygon_boxes_);
  numbers_.push_back(static_cast<int>(number));
  boxes_.push_back(widened(box, scale));
  bounds_.include(boxes_.back());
}

void SurfaceCaster::build(std::span<const ContactSurface* const> surfaces) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  if (blas_.size() < surfaces_.size()) blas_.resize(surfaces_.size());
  numbers_.clear();
  boxes_.clear();
  bounds_ = Aabb{};
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i] && !surfaces_[i]->empty()) build_blas(i);
  tlas_.build(boxes_, 1);
}

RayHit SurfaceCaster::cast(const dvec3& origin, const dvec3& direction, double max_depth) const {
  RayHit best;
  const Ray ray{origin, direction, max_depth};
  tlas_.cast(ray, [&](int box, double t_max) {
    const int number = numbers_[static_cast<std::size_t>(box)];
    const ContactSurface& surface = *surfaces_[static_cast<std::size_t>(number)];
    return blas_[static_cast<std::size_t>(number)].cast(Ray{origin, direction, t_max}, [&](int polygon, double reach) {
      best = nearer_hit(Ray{origin, direction, reach}, surface, number, polygon, best);
      return best.hit() ? best.depth : reach;
    });
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
