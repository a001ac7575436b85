// Error of a pad: the difference between its tets and the field that they approximate.
#pragma once

#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Error p/E - min(depth, H)/H over the volume of the tets. The depth is the distance to the skin.
struct PadError {
  double mean = 0;  ///< mean of its magnitude
  double rms = 0;
};

/// Estimates the error from 1024 points, each at a random place in its own part of the volume. The result has two
/// correct digits if the error is spread, and one if it is concentrated in about a hundredth of the pad. Deterministic.
/// Cost: 1024 closest-point queries, 2 ms.
PadError pad_error(const MeshIndex& index, const std::vector<dvec3>& vertices, const std::vector<ivec4>& tets,
                   const std::vector<double>& vertex_pressure, double modulus, double thickness);

}  // namespace taxel
