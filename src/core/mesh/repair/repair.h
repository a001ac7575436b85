// Repair of meshes: from the triangles of a file to a solid that can be soft, with a report of every change.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// Repairs a mesh as docs/theory.md describes. A pure function of its arguments, with the same result on any number of
/// threads. `thickness` is that of the pad [m]: a surface without an inside becomes a body of this thickness, or of a
/// twentieth of the diagonal if it is 0. Throws Error that names the place if the recipe is out of range, if its level
/// is `exact` or `keep` and forbids the steps that would close the mesh, or if the mesh encloses nothing; Cancelled
/// through `progress`.
RepairedMeshPtr repair_mesh(const TriMeshPtr& loaded, const RepairRecipe& recipe, double thickness,
                            Progress* progress = nullptr);

}  // namespace taxel
