// The motion between two copies of one mesh.
#pragma once

#include <optional>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the pose X for which to = X(from), for meshes with the same faces in the same order. Returns nothing if
/// there is none that brings each corner of `from` within `tolerance` [m] of its place.
std::optional<Pose> find_rigid_motion(const TriMesh& from, const TriMesh& to, double tolerance);

}  // namespace taxel
