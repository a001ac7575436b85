// Pairs of faces of a mesh that cut through each other.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/query/closest_point.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SelfIntersections {
  /// Number of pairs of faces without a common vertex, of which one is intersected by an edge of the other.
  int pairs = 0;
  int face_a = -1, face_b = -1;  ///< the first such pair, face_a < face_b
  dvec3 place{0};                ///< a point on both faces [m]
};

/// Finds intersecting pairs. Contact, coplanar overlap and cuts shallower than rounding are ignored. O(n log n) if few
/// boxes overlap.
SelfIntersections find_self_intersections(const TriMesh& mesh);
/// As above, with a tree that exists already.
SelfIntersections find_self_intersections(const TriMesh& mesh, const BoxTree& tree);
/// Returns the pairs f < g of triangles that intersect in this way, ascending, of which at least one is chosen: a
/// nonzero entry. O(n + c log c) for c chosen ones, if the pairs are few. Triangles without area have none.
std::vector<std::pair<int, int>> find_crossing_pairs(const std::vector<dvec3>& points, const std::vector<ivec3>& faces,
                                                     const std::vector<char>& chosen);
/// As above for all triangles, with a tree over their boxes; nothing if there are more than `most` pairs. The search
/// ends soon after it has found these.
std::optional<std::vector<std::pair<int, int>>> find_crossing_pairs(const std::vector<dvec3>& points,
                                                                    const std::vector<ivec3>& faces,
                                                                    const BoxTree& tree, std::size_t most);
/// Returns a nonzero entry for each triangle that intersects another one of its shell in this way. Takes less time than
/// a list of all pairs if most triangles have many. The search ends early, with some of these triangles, once
/// is_enough(entries) returns true.
std::vector<char> find_crossing_faces(const std::vector<dvec3>& points, const std::vector<ivec3>& faces,
                                      const BoxTree& tree, const std::vector<int>& shell_of_face,
                                      const std::function<bool(const std::vector<char>&)>& is_enough = {});

}  // namespace taxel
