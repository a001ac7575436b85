// The directions in which a taxel's shear is measured.
#pragma once

#include "core/layout/layout.h"

namespace taxel {

/// Unit vectors, frame M; e1, e2 and the taxel's normal n are right-handed.
struct TangentFrame {
  dvec3 e1{0}, e2{0};
};

/// Returns e1, the layout's direction `distal` projected into the taxel's tangent plane, and e2 = n x e1. If `distal`
/// is less than 6 degrees from the normal or its opposite, as at a finger's tip, its projection is not well defined; e1
/// is then the projection of `pad` reversed, which continues the direction of e1 along a path from the pad side over
/// the tip.
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
