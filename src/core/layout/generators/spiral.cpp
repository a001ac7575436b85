#include "core/layout/generators/spiral.h"

#include <fmt/format.h>

namespace taxel {

std::vector<Taxel> sunflower(const Spiral& spiral, const MeshIndex& skin, Beyond beyond) {
  require_count("spiral", "count", spiral.count);
  require_finite("spiral", "center", spiral.center);
  require_positive("spiral", "disc_radius", spiral.disc_radius);
  require_positive("spiral", "radius", spiral.radius);
  const dvec3 direction = require_direction("spiral", "direction", spiral.direction);
  const dvec3 zero = any_perpendicular(direction), quarter = glm::cross(-direction, zero);
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  std::vector<Taxel> taxels;
  for (int k = 0; k < spiral.count; ++k) {
    const double r = spiral.disc_radius * std::sqrt((k + 0.5) / spiral.count), theta = k * golden_angle;
    const dvec3 start = spiral.center + r * (std::cos(theta) * zero + std::sin(theta) * quarter);
    const auto at = skin_under(skin, start, direction, beyond, "spiral", fmt::format("taxel {}", k));
    if (at) taxels.push_back(taxel_on(skin.mesh(), *at, k, spiral.radius));
  }
  require_some("spiral", taxels);
  return taxels;
}

}  // namespace taxel
