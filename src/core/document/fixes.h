// Repairs: for what layout_check lists, the edit that mends it and the words that offer it.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/document/edit.h"
#include "core/layout/check/layout_check.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

struct Fix {
  std::string words;  ///< for a button: "Move taxel 3 to the surface, by 0.8 mm"
  Edit edit;
};

/// What mends `problem`, which must have been found on this project's layout as it is; nothing where that takes a
/// decision (a mesh that no repair closed, a subtaxel far away). `skin` are the shells that are sampled, null where the
/// mesh could not be read: then there are fewer repairs. To repair many, apply one, check again, and so on, in one
/// gesture.
///
/// A place or a normal is mended alone; a twin follows in its radius only. `mesh_sha256` is that of the mesh file read.
std::optional<Fix> fix_for(const Problem& problem, const Project& project, const MeshIndex* skin,
                           const std::string& mesh_sha256 = "");

/// What mends all that can be, as one edit, and what it would leave.
struct Mending {
  std::optional<Edit> edit;  ///< nothing: there is nothing to mend, or nothing that can be
  int mended = 0;            ///< problems that are gone then
  Problems left;
};
/// Fixes of taxels and settings one after the other, each round checked anew, because one may bring up or settle
/// another. What concerns the mesh is left, which is a decision, but for its repair. Errors and warnings count, notes
/// do not. `mesh` may live longer than the repair that it is of: one that a fix asks for counts as done.
Mending mend_all(const Project& project, const LayoutMesh& mesh);

/// The taxel and its subtaxels at the nearest points of the skin, with the smooth normals there. Where a centre is not
/// finite, what it belongs to stays.
TaxelChange projected(const Taxel& taxel, const MeshIndex& skin);

}  // namespace taxel
