// Taxels in the spiral of a sunflower's head, projected onto a skin.
#pragma once

#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A disc outside of the skin, and where it is projected to.
struct Spiral {
  int count = 1;
  dvec3 center{0};            ///< of the disc, outside of the skin [m]
  dvec3 direction{0, 0, -1};  ///< of projection, at right angles to the disc; any length
  double disc_radius = 0.01;  ///< [m]
  double radius = 0.005;      ///< of the receptive fields [m]
};

/// Taxel k lies at r = R sqrt((k + 1/2) / N), theta = k pi (3 - sqrt 5): equal area each (Vogel 1979, "A better way to
/// construct the sunflower head"), then where the ray along `direction` first meets the skin. The angle is counted
/// about -direction. Throws Error naming the parameter, or the taxel whose ray misses the skin.
std::vector<Taxel> sunflower(const Spiral& spiral, const MeshIndex& skin, Beyond beyond = Beyond::refuse);

}  // namespace taxel
