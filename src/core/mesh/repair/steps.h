// The steps of a repair, in the order in which they run, and their tools: shells, crossings, fillings of holes, solids.
// Each step removes one kind of fault and returns a report of it.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/query/box_tree.h"
#include "core/mesh/repair/draft.h"

namespace manifold {
class Manifold;
}

namespace taxel {

/// Removes duplicates of faces with the same three corners and the same winding.
RepairStep remove_repeated(Draft& draft);
/// Pairs of faces with the same three corners and opposite winding are removed: they enclose nothing.
RepairStep remove_folded(Draft& draft);
/// Removes the second of the two faces of each pair of remove_folded().
RepairStep remove_back_faces(Draft& draft);
/// Removes patches that hang on an edge of more than two faces and end open, the smallest first, as long as they make
/// up at most 2 % of the loaded area.
RepairStep remove_fins(Draft& draft, const RepairLimits& limits);
/// Joins the ends of edges that are no longer than the rounding of their points, 1e-9 of the diagonal: poles of globes.
RepairStep join_short_edges(Draft& draft, const RepairLimits& limits);
/// Joins points of open edges that rounding has torn apart. `length` is the largest distance between joined points.
/// A joined point gets the position of the one with the lowest number; `moved` counts the others.
RepairStep join_rims(Draft& draft, const RepairLimits& limits);
/// Flips the longest edge of each face without area, so that its apex splits the face across.
RepairStep turn_flat_faces(Draft& draft);
/// Splits an open edge at each rim point that is on the edge within 1e-5 of the diagonal.
RepairStep split_junctions(Draft& draft, const RepairLimits& limits);
/// Turns faces so that neighbours wind alike. `unorientable` gets bands on which this fails (a Moebius strip): a
/// nonzero entry for each of their faces. A body on which it fails keeps a seam of open edges.
RepairStep wind_alike(Draft& draft, std::vector<char>& unorientable);
/// Separates surfaces that only touch along an edge or at a point, so that solid lies between the faces of each.
RepairStep part_touching(Draft& draft, RepairChanges& changes);
/// Fills every hole.
RepairStep fill_holes(Draft& draft, const RepairLimits& limits);
/// Turns shells so that their volume is positive, or negative if they are cavities inside another shell.
RepairStep orient_shells(Draft& draft);
/// Replaces shells that overlap, touch along faces or lie inside each other by the union of the outward ones minus the
/// cavities. `area` is that of the surface that went inside.
RepairStep unite_shells(Draft& draft, const RepairLimits& limits);

// Connected shells of a draft.

/// Shells: faces connected by shared points, numbered by their first face.
struct FaceShells {
  std::vector<std::vector<int>> faces;  ///< faces of each shell, ascending
  std::vector<int> of_face;
};
FaceShells find_shells(const Draft& draft);

/// Signed volume of some faces by the divergence theorem [m^3]: meaningful if they are a closed shell.
double volume_of(const Draft& draft, const std::vector<int>& faces);

/// Some faces with the points that they use, in the order of the draft.
Draft extract_faces(const Draft& draft, const std::vector<int>& faces);
/// Appends all points and faces of another draft.
void append(Draft& draft, const Draft& other);

/// A tree over the boxes of the faces, for few queries.
BoxTree tree_of_faces(const Draft& draft);

/// Pairs of faces that cut through each other (self_intersection.h), the first one lower, ascending.
std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft);
/// The pairs of which at least one face is chosen: a nonzero entry.
std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft, const std::vector<char>& chosen);

/// The largest number of pairs of faces that cut through each other that a pressure field bears: three, or a thousandth
/// of the faces.
int few_pairs(int faces);

/// Removes the crossing faces of one closed shell, fills the holes and, as long as faces still cross, removes one more
/// ring of faces there. `pairs` are those of find_crossing_pairs(). Succeeds if the shell is then closed, at most
/// `allowed` pairs of faces cross, at most a tenth of its area is replaced, and new faces are within two edges of a
/// wrap of the old ones, as are old faces outside of the new shell. Otherwise `shell` remains as it was. Other faces
/// keep their points, bit for bit. New faces are marked kFilledFace. `step` counts the filled holes and the removed
/// faces. O(n log n) for n faces.
bool cut_crossings(Draft& shell, const std::vector<std::pair<int, int>>& pairs, std::size_t allowed,
                   const RepairLimits& limits, RepairStep& step);

/// The crossings of faces of the same shell.
struct OwnCrossings {
  std::vector<std::vector<std::pair<int, int>>> pairs;  ///< pairs of each shell, ascending; empty if it is hopeless
  /// A nonzero entry for each shell with more than a few pairs, on too much of its area to be cut out.
  std::vector<char> is_hopeless;
  int count = -1;  ///< number of all pairs, also of different shells, or -1 if not all are known

  /// The number of all pairs of the draft, which are searched if not all are known.
  [[nodiscard]] int count_all(const Draft& draft) const;
};
/// Finds the crossings within the shells of a draft. Only if most faces cross others some shells are hopeless: a list
/// of all pairs would take long there.
OwnCrossings find_own_crossings(const Draft& draft, const FaceShells& shells);

// Triangulation of the rim of a hole.

/// The rim of a hole: corners in the direction in which the faces that fill it run along it.
struct HoleRim {
  std::vector<dvec3> corners;  ///< in any unit
  std::vector<dvec3> normals;  ///< unit normal of the face outside of the edge from each corner to the next one
  /// Whether corners i and j may be joined by a new edge: not if an edge joins them already.
  std::function<bool(int, int)> may_join;
};

/// Triangles between the corners: of least (largest dihedral angle, area) by dynamic programming (Barequet, Sharir
/// 1995, "Filling gaps in the boundary of a polyhedron"; with the angles of Liepa 2003, "Filling holes in meshes").
/// O(n^3). Empty if no triangulation is allowed.
std::optional<std::vector<ivec3>> fill_by_least_angle(const HoleRim& rim);

/// Triangles between the corners: ears cut off the rim's projection onto its mean plane, for rims of many corners.
/// O(n^2). Empty if no ear is allowed at some point.
std::optional<std::vector<ivec3>> fill_by_ears(const HoleRim& rim);

// Drafts as solids of the Manifold library, and back.

/// How make_solid takes faces.
enum class SolidFaces {
  numbered,    ///< each carries its number through all operations, and no two are merged
  inside_out,  ///< numbered and turned: the faces of a cavity become those of a body
  mergeable    ///< coplanar ones may be merged
};

/// The solid within some faces of a draft, which are closed.
manifold::Manifold make_solid(const Draft& draft, const std::vector<int>& faces, SolidFaces kind);

/// Appends the faces of a solid with points of their own. The loaded face of each is that of the
/// numbered face whose number it has.
void append_solid(Draft& draft, const manifold::Manifold& solid, const std::vector<int>& source_loaded);
/// Appends the faces of a solid without numbers, marked kWrappedFace.
void append_wrapped(Draft& draft, const manifold::Manifold& solid);

}  // namespace taxel
