// The sides of a mesh's edges, gathered by edge: whatever shape the mesh has, manifold or not.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// One face's side of an edge.
struct EdgeSide {
  int low, high;     ///< vertices, low < high
  int face, corner;  ///< the edge runs from this corner to the next one
  bool forward;      ///< it runs from low to high
};

/// All sides: edge after edge in the order of (low, high), each in the order of faces. O(n log n).
std::vector<EdgeSide> edge_sides(std::size_t vertex_count, std::span<const ivec3> faces);
inline std::vector<EdgeSide> edge_sides(const TriMesh& mesh) {
  return edge_sides(mesh.vertices().size(), mesh.faces());
}

/// Calls body(sides of one edge) for every edge.
template <class Body>
void for_each_edge(std::span<const EdgeSide> sides, const Body& body) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    body(sides.subspan(begin, end - begin));
  }
}

}  // namespace taxel
