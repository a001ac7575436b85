// What is wrong with a mesh, in words; and the repairs that need no decision.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/mesh/query/self_intersection.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Everything about a mesh that a user should know, in this order:
///   warning mesh_open          edges with one face: no inside, no pressure field
///   error   mesh_nonmanifold   edges with more than two faces
///   error   mesh_winding       neighbours that wind differently
///   warning mesh_inverted      a closed mesh whose volume is negative: normals point inward
///   note    mesh_cavity        a closed shell inside another one: sensing leaves it out
///   note    mesh_shells        several outer shells
///   warning mesh_self_intersection  faces that cut through others: the pressure field overlaps there; a note where
///   they
///                              are less than a thousandth
///   warning mesh_units         a size that is hardly metres
/// Each names `file`, the number of places and the first of them. O(n log n).
Problems check_mesh(const TriMesh& mesh, const std::string& file);

/// Returns the first three of check_mesh(): the faults of a mesh's edges.
Problems check_edges(const TriMesh& mesh, const std::string& file);

/// The last two of check_mesh(), for a mesh of which the intersections `cuts` are known.
Problems check_cuts_and_size(const TriMesh& mesh, const SelfIntersections& cuts, const std::string& file);

/// Where a mesh that is not closed lets the inside out: each kind of bad edge with its number and first place.
std::string openings(const TriMesh& mesh);

/// The unit that the numbers of a mesh are probably in.
struct UnitGuess {
  std::string unit;  ///< "m" or "mm"
  double scale = 1;  ///< to metres
};
/// By the largest extent: up to 1 it is metres, above it millimetres. A guess: to be shown, never applied silently.
UnitGuess guess_unit(const TriMesh& mesh);

/// The same faces with the opposite winding.
TriMesh flipped(const TriMesh& mesh);

/// Neighbours wind alike, closed shells outward (enclosed ones inward). Face and vertex order are kept; what cannot be
/// oriented (a Moebius strip) keeps a seam, which check_mesh still reports.
TriMesh oriented(const TriMesh& mesh);

}  // namespace taxel
