// The positions of nearly parallel rays, seen along their mean direction. With them single precision decides for all
// rays but those near a rim whether they hit a contact polygon.
#pragma once

#include <array>
#include <span>

#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

/// Upper bound of the rounding errors of coordinates in single precision and of the results computed from them here, as
/// a fraction of the coordinates.
inline constexpr double kSingleRounding = 4e-6;

/// The view along an axis. A ray at place p is at (p.u + h p.u_slope, p.v + h p.v_slope) in the depth h along `axis`.
/// It intersects the plane of a polygon at h = h_c - height / rise. Here h_c is the depth of the polygon's centroid,
/// height the height over the plane of the ray's point at h_c, and rise = n_h + n_u u_slope + n_v v_slope with the
/// components of the plane's normal. In single precision the error is at most (spread + kSingleRounding X) (1 + tilt /
/// |rise|), X being the coordinates of the polygon.
struct RayView {
  /// Components of the perpendicular unit axes: of `axis`, of the axes of u and v, and 0.
  std::array<float, 4> x{}, y{}, z{};
  float spread = 0;  ///< error of positions [m]; infinite if rays are not nearly parallel
  float tilt = 0;
};

/// The place of a ray in a view.
struct RayPlace {
  float u = 0, v = 0, u_slope = 0, v_slope = 0;
};

/// Computes a view of rays, and the places of rays in the view.
class RayViewer {
 public:
  explicit RayViewer(std::span<const SensorRay* const> rays);
  [[nodiscard]] RayView view() const;
  [[nodiscard]] RayPlace place_of(const SensorRay& ray) const;

 private:
  dvec3 axis_{0, 0, 1}, u_axis_{1, 0, 0}, v_axis_{0, 1, 0};
  double spread_ = 0, tilt_ = 0;
};

/// Returns the view with these axes, the first one along the rays.
RayView make_view(const dvec3& axis, const dvec3& u_axis, const dvec3& v_axis, double spread, double tilt);

}  // namespace taxel
