// The directions in which a taxel's shear is measured, and a guess of the direction in which a finger points and of the
// side with which it touches, from its shape.
#pragma once

#include <optional>
#include <span>

#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

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

/// Guesses the directions of a finger, frame M. The finger points along the longest principal axis of its surface,
/// towards its rounded end. If neither end is clearly rounded, it points away from the origin of the file, because a
/// link of a robot has its joint there. The touching side is the side to which the taxels point, or without taxels the
/// bulging side. Directions within 25 degrees of an axis of the file are replaced by that axis. Empty if the shape has
/// no tip, such as a plate, or a body with two equal ends. The user must be informed of a guess.
std::optional<SensorFrame> guess_frame(const TriMesh& mesh, std::span<const Taxel> taxels = {});

/// Returns the axis of the file within 25 degrees of a direction, or the unit vector of the direction itself.
dvec3 snapped_to_axis(const dvec3& direction);

}  // namespace taxel
