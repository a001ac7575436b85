// Repair of meshes: from the triangles of a file to a solid that can be soft, with a report of every change in words.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// Repairs a mesh as docs/theory/mesh.md describes. A pure function of its arguments, with the same result on any
/// number of threads. `thickness` is that of the pad [m]: a surface without an inside becomes a body of this thickness,
/// or of a twentieth of the diagonal if it is 0. Throws Error that names the place if the recipe is out of range, if
/// its level is `exact` or `keep` and forbids the steps that would close the mesh, or if the mesh encloses nothing;
/// Cancelled through `progress`.
RepairedMeshPtr repair_mesh(const TriMeshPtr& loaded, const RepairRecipe& recipe, double thickness,
                            Progress* progress = nullptr);

/// Writes the message of a step and raises its severity if it changed more than 1 % of the area.
void finish_step(RepairStep& step, const RepairReport& report);

/// Returns one problem per step, with its code and severity, for `file` at /mesh/file. Empty if nothing was changed.
Problems repair_problems(const RepairReport& report, const std::string& file);

/// Returns the report in one line: "repaired: 2 folded faces and 1 fin removed (14.2 mm\u00b2, 0.8 % of the area), no
/// vertex moved", with an area for each kind of change. Empty if nothing was changed.
std::string repair_summary(const RepairReport& report);

}  // namespace taxel
