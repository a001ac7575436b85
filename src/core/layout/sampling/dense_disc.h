// A disc on a surface with its own density of samples.
#pragma once

#include "core/base/math.h"

namespace taxel {

/// A ball whose part of a surface has its own density of samples.
struct DenseDisc {
  dvec3 center{0};          ///< [m]
  dvec3 normal{0, 0, 1};    ///< unit normal
  double radius = 0;        ///< [m]
  double least_cosine = 0;  ///< least cosine between `normal` and that of a face in the part
  double density = 0;       ///< samples per m^2
  bool operator==(const DenseDisc&) const = default;
};

}  // namespace taxel
