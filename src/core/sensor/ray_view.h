// How rays that run nearly side by side look along their mean direction: enough to tell in single precision which of
// them pass by a contact polygon.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/sensor/sensor_ray.h"

namespace taxel {

/// More than what rounding to single precision makes of a coordinate and of its product with a unit vector, as a part
/// of the coordinates: by so much what is sieved in single precision is widened.
inline constexpr double kSingleRounding = 4e-6;

/// A piece of a ray: from t_min to t_max [m].
struct RayPiece {
  const SensorRay* ray;
  std::int32_t number;  ///< in SensorModel::rays
  double t_min, t_max;
  [[nodiscard]] dvec3 middle() const { return ray->origin + 0.5 * (t_min + t_max) * ray->direction; }
};

/// A ray with place p passes the depth h along `axis` at (p.u + h p.u_slope, p.v + h p.v_slope). If its piece meets a
/// disc of radius r about c, however that is turned, it passes c's depth within `stretch` r + `spread` of c.
struct RayView {
  /// Components of the axes, which are unit and at right angles: of `axis`, of those of u and v, and 0.
  std::array<float, 4> x{}, y{}, z{};
  float stretch = 1;
  float spread = 0;  ///< [m]
};

struct RayPlace {
  float u = 0, v = 0, u_slope = 0, v_slope = 0;
  float middle = 0, half = 0;  ///< of the piece: depths from middle - half to middle + half
};

/// Makes a view, and the places of rays in it.
class RayViewer {
 public:
  explicit RayViewer(std::span<const RayPiece> pieces);
  [[nodiscard]] RayView view() const;
  [[nodiscard]] RayPlace place_of(const RayPiece& piece) const;

 private:
  dvec3 axis_{0, 0, 1}, u_axis_{1, 0, 0}, v_axis_{0, 1, 0};
  double stretch_ = 1, spread_ = 0;
  bool sloped_ = false;  // else rays count as parallel, where the middle of their piece is
};

}  // namespace taxel
