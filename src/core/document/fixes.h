// Repairs of the problems that layout_check lists, and of taxels whose mesh was replaced.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/document/edit.h"
#include "core/layout/check/layout_check.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A repair of a problem: an edit and the text that offers it.
struct Fix {
  std::string words;  ///< text of a button: "Move taxel 3 to the surface, by 0.8 mm"
  Edit edit;
};

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

/// Returns the repair of a problem whose pointer begins with /taxels, or nothing if no repair is known.
std::optional<Fix> fix_of_taxel(const Problem& problem, const Project& project, const MeshIndex* skin);

/// Returns the change that moves the taxel and its subtaxels to the nearest points of the skin and gives them the
/// smooth normals there. A taxel or subtaxel whose centre is not finite does not change.
TaxelChange projected(const Taxel& taxel, const MeshIndex& skin);

// Taxels after a replacement of their mesh: their distances from the new skin, and the edit that moves them onto it.

/// Distances of the taxels' centres from a skin [m].
struct SurfaceDistances {
  int taxels = 0;
  double mean = 0, largest = 0;
  int farthest = 0;  ///< id of the farthest taxel
};
SurfaceDistances distances_to(const MeshIndex& skin, const Layout& layout);

/// Returns a sentence: "12 taxels lie 0.31 mm from its surface on average, taxel 3 the farthest with 0.82 mm"; empty
/// without taxels.
std::string distances_text(const SurfaceDistances& distances);

/// Returns the edit that moves all taxels and subtaxels to the nearest points of the skin and gives them its normals
/// there. Mirrored taxels do not follow, because each taxel moves by itself.
SetTaxels projected_onto(const MeshIndex& skin, const Layout& layout);

}  // namespace taxel
