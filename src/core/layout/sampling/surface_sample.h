// One sample of a surface: a point with the part of the surface that it represents.
#pragma once

#include "core/base/math.h"

namespace taxel {

struct SurfaceSample {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};  ///< unit normal of the face
  int face = -1;
  double area = 0.0;   ///< represented area [m^2]; all samples sum to the sampled area
  double share = 1.0;  ///< number of samples of the layout's density that it represents
};

}  // namespace taxel
