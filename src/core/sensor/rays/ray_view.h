// How rays that run nearly side by side look along their mean direction: enough to tell in single precision, of all but
// the few that pass by a rim, whether they meet a contact polygon.
#pragma once

#include <array>
#include <span>

#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

/// More than what rounding to single precision makes of a coordinate, and of what is computed from it here, as a part
/// of the coordinates.
inline constexpr double kSingleRounding = 4e-6;

/// A ray with place p passes the depth h along `axis` at (p.u + h p.u_slope, p.v + h p.v_slope). There it meets the
/// plane of a polygon if h = h_c - height / rise, height being that of where it passes the depth h_c of the polygon's
/// centroid, and rise = n_h + n_u u_slope + n_v v_slope with the components of the plane's normal. In single precision
/// that is right to (spread + kSingleRounding X) (1 + tilt / |rise|), X the coordinates of the polygon.
struct RayView {
  /// Components of the axes, which are unit and at right angles: of `axis`, of those of u and v, and 0.
  std::array<float, 4> x{}, y{}, z{};
  float spread = 0;  ///< [m]; infinite where rays run in too many directions to have a view
  float tilt = 0;
};

struct RayPlace {
  float u = 0, v = 0, u_slope = 0, v_slope = 0;
};

/// Makes a view, and the places of rays in it.
class RayViewer {
 public:
  explicit RayViewer(std::span<const SensorRay* const> rays);
  [[nodiscard]] RayView view() const;
  [[nodiscard]] RayPlace place_of(const SensorRay& ray) const;

 private:
  dvec3 axis_{0, 0, 1}, u_axis_{1, 0, 0}, v_axis_{0, 1, 0};
  double spread_ = 0, tilt_ = 0;
};

/// The view with these axes: the first one along the rays.
RayView make_view(const dvec3& axis, const dvec3& u_axis, const dvec3& v_axis, double spread, double tilt);

}  // namespace taxel
