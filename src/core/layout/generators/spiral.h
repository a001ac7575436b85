// Taxels in the spiral of a sunflower's seeds, projected onto a skin.
#pragma once

#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A disc outside of the skin, and the direction of its projection.
struct Spiral {
  int count = 1;
  dvec3 center{0};            ///< centre of the disc, outside of the skin [m]
  dvec3 direction{0, 0, -1};  ///< direction of projection, the disc's normal; any length
  double disc_radius = 0.01;  ///< [m]
  double radius = 0.005;      ///< radius of the receptive fields [m]
};

/// Returns taxels of equal area each (Vogel 1979, "A better way to construct the sunflower head"). Taxel k is at
/// r = R sqrt((k + 1/2) / N), theta = k pi (3 - sqrt 5) about -direction on the disc, and then at the first
/// intersection of the ray along `direction` with the skin. Throws Error that names the parameter, or the taxel whose
/// ray misses the skin.
std::vector<Taxel> sunflower(const Spiral& spiral, const MeshIndex& skin, Beyond beyond = Beyond::refuse);

}  // namespace taxel
