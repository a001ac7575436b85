// Scenes of solid bodies alone, as a simulation without sensors shows them.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::test {

struct PlacedBody {
  TriMeshPtr mesh;
  Pose X_WG;
};
/// Returns a scene of bodies of the same grey, without a grid.
ui::SceneInput bodies(const std::vector<PlacedBody>& placed);
inline constexpr std::array<float, 4> kBodyColor{0.55f, 0.57f, 0.60f, 1};

/// Returns both meshes as one mesh. The second mesh is moved, and if `cavity`, its faces are reversed.
TriMeshPtr joined(const TriMesh& a, const TriMesh& b, const dvec3& shift, bool cavity = false);

}  // namespace taxel::test
