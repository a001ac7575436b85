#include "core/sensor/cast_rays.h"

#include <tuple>

namespace taxel {
namespace {

/// How much boxes and slabs grow, in units in the last place of the coordinates involved: their distances and the
/// triangle test's are computed in different ways, and no hit may be lost to rounding.
double margin_of(const Aabb& box) {
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  return 64.0 * std::numeric_limits<double>::epsilon() * std::max({largest.x, largest.y, largest.z});
}

Aabb widened(const Aabb& box, double margin) {
  return {box.lo - margin, box.hi + margin};
}

/// Third axis along the mean normal of the surface, as columns.
dmat3 patch_axes(const ContactSurface& surface) {
  dvec3 sum(0);
  for (const ContactPolygon& polygon : surface.polygons) sum += polygon.area * polygon.normal;
  const double length = glm::length(sum);
  if (!(length > 0.0)) return dmat3(1.0);
  const dvec3 normal = sum / length, u = any_perpendicular(normal);
  return {u, glm::cross(normal, u), normal};
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

void SurfaceCaster::add_instance(std::size_t number) {
  const ContactSurface& surface = *surfaces_[number];
  Instance instance;
  instance.surface = static_cast<int>(number);
  for (const dvec3& v : surface.vertices) instance.box.include(v);
  const double margin = margin_of(instance.box);
  instance.box = widened(instance.box, margin);
  instance.axes = patch_axes(surface);

  boxes_.clear();
  for (const ContactPolygon& polygon : surface.polygons) {
    Aabb box;
    for (int i = 0; i < polygon.count; ++i)
      box.include(surface.vertices[static_cast<std::size_t>(polygon.first + i)] * instance.axes);
    boxes_.push_back(widened(box, margin));
  }
  blas_[number].build(boxes_);
  instance.lo = blas_[number].nodes()[0].box.lo.z;
  instance.hi = blas_[number].nodes()[0].box.hi.z;
  instances_.push_back(instance);
}

void SurfaceCaster::build(std::span<const ContactSurface* const> surfaces) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  if (blas_.size() < surfaces_.size()) blas_.resize(surfaces_.size());
  instances_.clear();
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i] && !surfaces_[i]->empty()) add_instance(i);
  boxes_.clear();
  for (const Instance& instance : instances_) boxes_.push_back(instance.box);
  tlas_.build(boxes_, 1);
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
  const RayTriangleTest test(ray);
  tlas_.cast(ray, [&](int number, double t_max) {
    const Instance& instance = instances_[static_cast<std::size_t>(number)];
    const auto surface = static_cast<std::size_t>(instance.surface);
    const Ray turned{origin * instance.axes, direction * instance.axes, t_max};
    return blas_[surface].cast(turned, [&](int polygon, double reach) {
      best = nearer_hit(test, reach, *surfaces_[surface], instance.surface, polygon, best);
      return best.hit() ? best.depth : reach;
    });
  });
  return best;
}

void cast_rays(const SensorModel& model, const SurfaceCaster& caster, std::vector<RayHit>& hits) {
  hits.assign(model.rays.size(), RayHit{});
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const SensorRay& ray = model.rays[i];
    if (caster.may_hit(ray.origin, ray.origin + ray.max_depth * ray.direction))
      hits[i] = caster.cast(ray.origin, ray.direction, ray.max_depth);
  }
}

}  // namespace taxel
