// Guesses the direction in which a finger points, and the side with which it touches, from its shape.
#pragma once

#include <optional>
#include <span>

#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Guesses the directions of a finger, frame M. The finger points along the longest principal axis of its surface,
/// towards its rounded end. If neither end is clearly rounded, it points away from the origin of the file, because a
/// link of a robot has its joint there. The touching side is the side to which the taxels point, or without taxels the
/// bulging side. Directions within 25 degrees of an axis of the file are replaced by that axis. Empty if the shape has
/// no tip, such as a plate, or a body with two equal ends. The user must be informed of a guess.
std::optional<SensorFrame> guess_frame(const TriMesh& mesh, std::span<const Taxel> taxels = {});

/// Returns the axis of the file within 25 degrees of a direction, or the unit vector of the direction itself.
dvec3 snapped_to_axis(const dvec3& direction);

}  // namespace taxel
