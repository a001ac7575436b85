// Repairs of the problems that layout_check lists.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/document/fix.h"
#include "core/layout/check/layout_check.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns the repair of `problem`, which must be a problem of this project's present layout. Returns nothing if the
/// user must decide (a mesh that no repair closed, a subtaxel far away). `skin` holds the sampled shells; it is null if
/// the mesh is not readable, and then fewer repairs exist. To repair many problems in one gesture, apply one repair,
/// check again, and repeat.
///
/// A repair of a centre or a normal does not change the mirrored taxel; a repair of a radius does. `mesh_sha256` is the
/// hash of the mesh file.
std::optional<Fix> fix_for(const Problem& problem, const Project& project, const MeshIndex* skin,
                           const std::string& mesh_sha256 = "");

/// The repair of all problems as one edit, and the problems that remain.
struct Mending {
  std::optional<Edit> edit;  ///< empty if there is nothing to repair, or no repair is known
  int mended = 0;            ///< number of problems that the edit removes
  Problems left;
};
/// Repairs taxels and settings one after the other, and checks again after each round, because a repair can cause or
/// remove another problem. Problems of the mesh remain, because the user decides about them; the exception is the
/// repair of the mesh itself. Errors and warnings are repaired, notes are not. `mesh` may be older than the repair
/// settings: a repair of the mesh that an edit requests is regarded as done.
Mending mend_all(const Project& project, const LayoutMesh& mesh);

}  // namespace taxel
