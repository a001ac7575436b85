// Finds first hits without trees or tables, by testing every ray with every polygon.
#pragma once

#include "core/mesh/query/bvh.h"
#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

/// Distance from a rim below which both a hit and a miss are correct, as a fraction of the unit of length. Rays may hit
/// beyond rims by kRimReach of the coordinates.
inline constexpr double kRimUnclear = 2e-8;

struct OracleHit {
  RayHit hit;
  double margin = std::numeric_limits<double>::infinity();  ///< distance to the nearest rim [m]
};

/// Finds hits by formulas that differ from the caster's: plane first, then the distances from the sides of the convex
/// polygon.
inline OracleHit oracle(const std::vector<const ContactSurface*>& surfaces, const Ray& ray) {
  OracleHit best;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    for (std::size_t i = 0; i < surfaces[s]->polygons.size(); ++i) {
      const ContactPolygon& p = surfaces[s]->polygons[i];
      const double t = glm::dot(p.centroid - ray.origin, p.normal) / glm::dot(ray.direction, p.normal);
      if (!(t > -1e-9 && t < ray.t_max + 1e-9)) continue;
      const dvec3 x = ray.origin + t * ray.direction;
      double inside = std::min(t, ray.t_max - t);
      for (int c = 0; c < p.count; ++c) {
        const dvec3& a = surfaces[s]->vertices[static_cast<std::size_t>(p.first + c)];
        const dvec3& b = surfaces[s]->vertices[static_cast<std::size_t>(p.first + (c + 1) % p.count)];
        inside = std::min(inside, glm::dot(glm::cross(p.normal, glm::normalize(b - a)), x - a));
      }
      best.margin = std::min(best.margin, std::abs(inside));
      if (inside < 0.0 || (best.hit.hit() && t >= best.hit.depth)) continue;
      if (best.hit.hit()) best.margin = std::min(best.margin, best.hit.depth - t);
      best.hit = {static_cast<int>(s), static_cast<int>(i), t, p.pressure + glm::dot(p.gradient, x - p.centroid)};
    }
  }
  return best;
}

/// Finds hits by the caster's own test of one ray with one polygon. Trees and tables must give the same bits.
class WithoutTrees {
 public:
  explicit WithoutTrees(std::vector<const ContactSurface*> surfaces) : surfaces_(std::move(surfaces)) {
    for (const ContactSurface* surface : surfaces_) {
      auto& planes = planes_.emplace_back(surface->vertices.size());
      for (const ContactPolygon& p : surface->polygons) fill_edge_planes(*surface, p, planes.data() + p.first);
    }
  }
  [[nodiscard]] RayHit cast(const SensorRay& ray) const {
    RayHit best;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      for (std::size_t i = 0; i < surfaces_[s]->polygons.size(); ++i) {
        const ContactPolygon& p = surfaces_[s]->polygons[i];
        const auto found = hit_polygon(ray.origin, ray.direction, 0, ray.max_depth, p, planes_[s].data() + p.first);
        if (!found) continue;
        const RayHit hit{static_cast<int>(s), static_cast<int>(i), found->t, found->pressure};
        if (hit.before(best)) best = hit;
      }
    }
    return best;
  }

 private:
  std::vector<const ContactSurface*> surfaces_;
  std::vector<std::vector<EdgePlane>> planes_;
};

inline std::vector<const ContactSurface*> pointers(const std::vector<ContactSurface>& surfaces) {
  std::vector<const ContactSurface*> list;
  for (const ContactSurface& s : surfaces) list.push_back(&s);
  return list;
}

}  // namespace taxel
