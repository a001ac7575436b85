// Solid bodies alone, as a simulation without sensors would show them.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::test {

struct PlacedBody {
  TriMeshPtr mesh;
  Pose X_WG;
};
/// Of one grey, without a grid.
ui::SceneInput bodies(const std::vector<PlacedBody>& placed);
inline constexpr std::array<float, 4> kBodyColor{0.55f, 0.57f, 0.60f, 1};

/// Both meshes as one; the second is moved, and with `cavity` its faces are turned.
TriMeshPtr joined(const TriMesh& a, const TriMesh& b, const dvec3& shift, bool cavity = false);

}  // namespace taxel::test
