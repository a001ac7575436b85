// The directions of a taxel's shear.
#pragma once

#include "core/layout/layout.h"

namespace taxel {

/// Unit vectors, frame M; e1, e2 and the taxel's normal n are right-handed.
struct TangentFrame {
  dvec3 e1{0}, e2{0};
};

/// e1 is the layout's direction `distal` laid into the taxel's tangent plane, e2 = n x e1. Where distal is less than 6
/// degrees from the normal or its opposite, as at a finger's tip, it has no direction to speak of there: then e1 is
/// that of `pad` reversed, which is where distal turns to as one walks from the pad side over the tip.
inline TangentFrame tangent_frame(const SensorFrame& frame, const dvec3& taxel_normal) {
  const double least_sine = 0.1;
  const dvec3 n = glm::normalize(taxel_normal);
  const auto in_plane = [&](const dvec3& direction) {
    const dvec3 u = glm::normalize(direction);
    return u - glm::dot(u, n) * n;
  };
  dvec3 e1 = in_plane(frame.distal);
  if (glm::length(e1) < least_sine) e1 = in_plane(-frame.pad);
  e1 = glm::normalize(e1);
  return {e1, glm::cross(n, e1)};
}

}  // namespace taxel
