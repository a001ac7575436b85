// Problems of a mesh, and the repairs that need no decision: units and the direction of faces. Findings have the
// consequence of a problem for a sensor in words.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/query/self_intersection.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the problems of a mesh in this order:
///   warning mesh_open          edges with one face: no inside, no pressure field
///   error   mesh_nonmanifold   edges with more than two faces
///   error   mesh_winding       neighbours that wind differently
///   warning mesh_inverted      a closed mesh whose volume is negative: normals point inward
///   note    mesh_cavity        a closed shell inside another one: sensing leaves it out
///   note    mesh_shells        several outer shells
///   warning mesh_self_intersection  faces that cut through others: the pressure field overlaps there; a note if these
///                              are less than a thousandth of the faces
///   warning mesh_units         a size that is probably not in metres
/// Each names `file`, the number of places and the first of them. O(n log n).
Problems check_mesh(const TriMesh& mesh, const std::string& file);
/// As above, with the tree of the faces that exists already.
Problems check_mesh(const MeshIndex& index, const std::string& file);

/// Returns the first three of check_mesh(): the faults of a mesh's edges.
Problems check_edges(const TriMesh& mesh, const std::string& file);

/// Returns the last two of check_mesh(), for a mesh whose intersections `cuts` are known.
Problems check_cuts_and_size(const TriMesh& mesh, const SelfIntersections& cuts, const std::string& file);

/// Returns the messages of check_edges(), joined by semicolons.
std::string openings(const TriMesh& mesh);

/// The probable unit of the coordinates of a mesh.
struct UnitGuess {
  std::string unit;  ///< "m" or "mm"
  double scale = 1;  ///< factor to metres
};
/// Guesses metres if the largest extent is up to 1, and millimetres above. To be displayed, never applied silently.
UnitGuess guess_unit(const TriMesh& mesh);

/// Returns the mesh with the opposite winding.
TriMesh flipped(const TriMesh& mesh);

/// Returns the mesh with faces turned so that neighbours wind alike and closed shells wind outward, or inward if
/// another shell encloses them. The order of faces and vertices is kept. A surface that cannot be oriented (a Moebius
/// strip) keeps a seam, which check_mesh still reports.
TriMesh oriented(const TriMesh& mesh);

/// A problem of a mesh in words, with its meaning for a sensor.
struct MeshFinding {
  Severity severity = Severity::note;
  std::string code;     ///< code of check_mesh, or "mesh_repaired"
  std::string what;     ///< sentence with the number of places and the first of them
  std::string meaning;  ///< consequence for sensing
};
using MeshFindings = std::vector<MeshFinding>;

/// Returns the problems of check_mesh, the most severe first, followed by `notes`, the changes made while reading
/// (LoadedMesh::notes). The cost is that of check_mesh.
MeshFindings mesh_report(const TriMesh& mesh, const std::vector<std::string>& notes);
/// As above, with the tree of the faces that exists already.
MeshFindings mesh_report(const MeshIndex& index, const std::vector<std::string>& notes);

/// Returns the numbers of findings, as in "3 warnings, 1 note". Empty if there are none.
std::string count_findings(const MeshFindings& findings);

}  // namespace taxel
