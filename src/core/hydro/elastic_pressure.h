// The pressure of a compressed layer on a rigid core: p = E d / H.
#pragma once

namespace taxel {

/// Returns the pressure at a depth below the skin of a layer [Pa]. Depth and thickness in metres, modulus in pascals.
inline double elastic_pressure(double depth, double thickness, double modulus) {
  return modulus * depth / thickness;
}

}  // namespace taxel
