// Guess of the direction in which a finger points and of the side with which it touches, from its shape.
#pragma once

#include <optional>
#include <span>

#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Guesses the directions of a finger, frame M. The finger points along the longest principal axis of its surface,
/// towards the end that is rounded; where neither end is clearly so, away from the origin of the file, where a link of
/// a robot has its joint. It touches where its taxels look; without taxels, on the side that bulges. Directions within
/// 25 degrees of an axis of the file are that axis. Empty where the shape has no tip: a plate, or a body that is the
/// same at both ends. A guess: to be shown, and stated where it is used.
std::optional<SensorFrame> guess_frame(const TriMesh& mesh, std::span<const Taxel> taxels = {});

/// The axis of the file within 25 degrees of a direction, or the unit vector of the direction itself.
dvec3 snapped_to_axis(const dvec3& direction);

}  // namespace taxel
