// Error of a pad: the difference between its tets and the field that they approximate.
#pragma once

#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// p/E - min(depth, H)/H over the tets' volume, the depth being the distance to the skin.
struct PadError {
  double mean = 0;  ///< mean of its magnitude
  double rms = 0;
};

/// By 1024 points, each at random in its own share of the volume: two digits where the error is spread, one where it
/// sits in some hundredth of the pad. Deterministic. Cost: as many closest-point queries, 2 ms.
PadError pad_error(const MeshIndex& index, const std::vector<dvec3>& vertices, const std::vector<ivec4>& tets,
                   const std::vector<double>& vertex_pressure, double modulus, double thickness);

}  // namespace taxel
