// First hits of the sensor's rays on its contact surfaces: one BLAS per surface, a TLAS over them.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct RayHit {
  int surface = -1;       ///< -1: miss
  int polygon = -1;
  double depth = 0;       ///< along the ray [m]
  double pressure = 0;    ///< p0 there, by barycentric interpolation [Pa]; 0 for a miss
};

/// Acceleration structures, kept between steps.
class SurfaceCaster {
 public:
  /// Surfaces in frame M. They must outlive the casts.
  void build(std::span<const ContactSurface* const> surfaces);
  [[nodiscard]] RayHit cast(const dvec3& origin, const dvec3& direction, double max_depth) const;

 private:
  struct Blas;
  std::vector<const ContactSurface*> surfaces_;
  std::vector<Bvh> blas_;
  Bvh tlas_;
  std::vector<Aabb> boxes_;
};

/// hits[i] belongs to model.rays[i]. Ties go to the lower surface, then the lower polygon.
void cast_rays(const SensorModel& model, const SurfaceCaster& caster, std::vector<RayHit>& hits);

}  // namespace taxel
