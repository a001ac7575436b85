// The part of another surface that lies within a skin, such as that of a collision geom in a robot's visual mesh.
#pragma once

#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns the share of the area of a surface that lies within a skin, or at most `thickness` [m] or 2 % of the skin's
/// diagonal outside of it, because simple geoms and meshes of few faces differ a little. `X_skin` leads from the frame
/// of the surface to that of the skin. Large triangles count by parts. The skin should be closed.
double share_within_skin(const TriMesh& surface, const RigidTransform& X_skin, const MeshIndex& skin, double thickness);

}  // namespace taxel
