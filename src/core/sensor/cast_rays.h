// First hits of the sensor's rays on its contact surfaces: one BLAS per surface, a TLAS over them.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/mesh/ray_triangle.h"
#include "core/mesh/tlas.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct RayHit {
  int surface = -1;  ///< -1: miss
  int polygon = -1;
  double depth = 0;     ///< along the ray [m]
  double pressure = 0;  ///< p0 there, by barycentric interpolation [Pa]; 0 for a miss
  [[nodiscard]] bool hit() const { return surface >= 0; }
};

/// Hit on one polygon, fanned from its first vertex, from either side, rim included; `best` otherwise. The polygon
/// replaces `best` when it is nearer, or as near and lower in number (surface first).
RayHit nearer_hit(const RayTriangleTest& ray, double max_depth, const ContactSurface& surface, int surface_number,
                  int polygon, const RayHit& best);

/// Acceleration structures, kept between steps. Movable, not copyable: the TLAS refers to the BLAS.
class SurfaceCaster {
 public:
  SurfaceCaster() = default;
  SurfaceCaster(SurfaceCaster&&) = default;
  SurfaceCaster& operator=(SurfaceCaster&&) = default;

  /// Surfaces in frame M; null or empty ones hold nothing. They must outlive the casts. Keeps the memory of the last
  /// build, so that no step allocates once the largest surface was seen.
  void build(std::span<const ContactSurface* const> surfaces);

  /// First hit with depth in [0, max_depth]; ties go to the lower surface, then the lower polygon.
  [[nodiscard]] RayHit cast(const dvec3& origin, const dvec3& direction, double max_depth) const;

  /// Box of all surfaces; empty when there is nothing to hit.
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }

 private:
  void build_blas(std::size_t number);

  std::vector<const ContactSurface*> surfaces_;
  std::vector<Bvh> blas_;  // of surface i; more than surfaces_ where earlier steps had more
  std::vector<const Bvh*> trees_;
  Tlas tlas_;
  std::vector<Aabb> polygon_boxes_;
  Aabb bounds_;
};

/// hits[i] belongs to model.rays[i]. Ties go to the lower surface, then the lower polygon.
void cast_rays(const SensorModel& model, const SurfaceCaster& caster, std::vector<RayHit>& hits);

}  // namespace taxel
