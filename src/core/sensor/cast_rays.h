// First hits of the sensor's rays on its contact surfaces: one BLAS per surface, a TLAS over them.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/mesh/bvh.h"
#include "core/mesh/ray_triangle.h"
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

/// Acceleration structures, kept between steps: per surface a BLAS, turned so that its third axis is the surface's mean
/// normal (a contact patch is flat, and so are its boxes then); over them a TLAS. Leaves are tested in frame M.
class SurfaceCaster {
 public:
  /// Surfaces in frame M; null or empty ones hold nothing. They must outlive the casts. Keeps the memory of the last
  /// build, so that no step allocates once the largest surface was seen.
  void build(std::span<const ContactSurface* const> surfaces);

  /// First hit with depth in [0, max_depth]; ties go to the lower surface, then the lower polygon.
  [[nodiscard]] RayHit cast(const dvec3& origin, const dvec3& direction, double max_depth) const;

  /// False only where the segment cannot meet any surface: a few comparisons that spare most rays the walk.
  [[nodiscard]] bool may_hit(const dvec3& from, const dvec3& to) const;

 private:
  struct Instance {
    int surface = 0;
    Aabb box;               // frame M
    dmat3 axes{1.0};        // of the BLAS, in its columns: p_B = p_M * axes
    double lo = 0, hi = 0;  // of the surface along the third axis [m]
  };
  void add_instance(std::size_t number);

  std::vector<const ContactSurface*> surfaces_;
  std::vector<Bvh> blas_;  // of surface i; more than surfaces_ where earlier steps had more
  Bvh tlas_;
  std::vector<Instance> instances_;  // TLAS primitives: the surfaces that are not empty
  std::vector<Aabb> boxes_;
};

/// hits[i] belongs to model.rays[i]. Ties go to the lower surface, then the lower polygon.
void cast_rays(const SensorModel& model, const SurfaceCaster& caster, std::vector<RayHit>& hits);

}  // namespace taxel
