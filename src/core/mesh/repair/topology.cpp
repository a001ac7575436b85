#include "core/mesh/repair/topology.h"

#include <array>

namespace taxel {

std::vector<HalfEdgePair> twin_pairs(const EdgeTopology& edges) {
  std::vector<HalfEdgePair> pairs;
  pairs.reserve(at(edges.edge_count()));
  edges.for_each_edge([&](std::span<const int> edge) {
    if (edges.kind(edge) == EdgeKind::inner) pairs.push_back({edge[0], edge[1]});
  });
  return pairs;
}

DisjointSets join_corners(const Draft& draft, std::span<const HalfEdgePair> pairs) {
  DisjointSets corners(3 * draft.faces.size());
  for (const HalfEdgePair& pair : pairs) {
    corners.unite(pair.a, next_edge(pair.b));
    corners.unite(next_edge(pair.a), pair.b);
  }
  return corners;
}

namespace {

/// Adds a face with three vertices of its own.
void add_alone(Topology& topology, const Draft& draft, int face) {
  std::array<OpenMesh::VertexHandle, 3> handles;
  for (int c = 0; c < 3; ++c) {
    const dvec3& p = draft.corner(face, c);
    handles[at(c)] = topology.mesh.add_vertex({p.x, p.y, p.z});
    topology.vertex_of.push_back(draft.faces[at(face)][c]);
  }
  topology.mesh.add_face(handles[0], handles[1], handles[2]);
}

}  // namespace

/// Around one vertex of one fan the faces lie in a row or in a ring, each joined to the next across an edge that both
/// pass in opposite directions. So no side is taken twice, and OpenMesh accepts every face. Several pairs at one edge
/// that share both of its ends are the exception: parted.cpp splits such edges beforehand, and a face that OpenMesh
/// still refuses gets vertices of its own.
Topology make_topology(const Draft& draft, std::span<const HalfEdgePair> pairs) {
  DisjointSets corners = join_corners(draft, pairs);
  Topology topology;
  topology.mesh.reserve(draft.points.size(), 3 * draft.faces.size() / 2, draft.faces.size());
  std::vector<OpenMesh::VertexHandle> vertex_of_fan(3 * draft.faces.size());
  for (int f = 0; f < draft.face_count(); ++f) {
    std::array<OpenMesh::VertexHandle, 3> handles;
    for (int c = 0; c < 3; ++c) {
      OpenMesh::VertexHandle& handle = vertex_of_fan[at(corners.find(3 * f + c))];
      if (!handle.is_valid()) {
        const dvec3& p = draft.corner(f, c);
        handle = topology.mesh.add_vertex({p.x, p.y, p.z});
        topology.vertex_of.push_back(draft.faces[at(f)][c]);
      }
      handles[at(c)] = handle;
    }
    if (!topology.mesh.add_face(handles[0], handles[1], handles[2]).is_valid()) add_alone(topology, draft, f);
  }
  return topology;
}

int find_patches(const Draft& draft, std::span<const HalfEdgePair> pairs, std::vector<int>& patch_of_face) {
  DisjointSets sets(draft.faces.size());
  for (const HalfEdgePair& pair : pairs) sets.unite(pair.a / 3, pair.b / 3);
  patch_of_face.resize(draft.faces.size());
  int count = 0;
  for (int f = 0; f < draft.face_count(); ++f) {
    const int first = sets.find(f);
    patch_of_face[at(f)] = first == f ? count++ : patch_of_face[at(first)];
  }
  return count;
}

}  // namespace taxel
