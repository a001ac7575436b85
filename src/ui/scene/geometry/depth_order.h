// Sorts faces from back to front for blending.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace taxel::ui {

/// Sorts triangles (given by three indices each into `corner positions`) by the depth of their centroids along
/// `direction` (from the eye into the scene, in the mesh's frame), farthest first. A counting sort over 4096 depths:
/// linear, stable and the same everywhere. `centroids` one per face; writes three indices per face into `out`.
void order_back_to_front(std::span<const glm::vec3> centroids, std::span<const std::uint32_t> indices,
                         const glm::vec3& direction, std::vector<std::uint32_t>& out);

}  // namespace taxel::ui
