// The half-edges of a draft, by OpenMesh: one vertex per fan of faces, so that every draft becomes a manifold. The
// pairs of half-edges that belong together, also at edges of more than two faces.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <vector>

#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/repair/draft.h"

namespace taxel {

struct DraftTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// Two half-edges of an edge across which the surface continues. They run in opposite directions.
struct HalfEdgePair {
  int a = -1, b = -1;
};

/// Faces of OpenMesh have the numbers of the draft's faces. Where the draft is no orientable manifold it is cut open.
struct Topology {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<DraftTraits>;
  Mesh mesh;
  std::vector<int> vertex_of;  ///< point of the draft for each vertex of OpenMesh
};

/// The pairs of twins, in the order of edges.
std::vector<HalfEdgePair> twin_pairs(const EdgeTopology& edges);
/// Joins the corners 3 face + c that meet across pairs: each set is one fan of faces at a point.
DisjointSets join_corners(const Draft& draft, std::span<const HalfEdgePair> pairs);
/// Makes one vertex of each set of join_corners(). Every face is kept.
Topology make_topology(const Draft& draft, std::span<const HalfEdgePair> pairs);

/// Groups of faces that are connected across `pairs`, numbered by their first face. Returns the number of groups.
int find_patches(const Draft& draft, std::span<const HalfEdgePair> pairs, std::vector<int>& patch_of_face);

/// Pairs of half-edges with solid between their faces: twins, and those of an edge of more than two faces by the angles
/// of the faces around the edge. Half-edges that run alike, or that are too many, stay without a partner.
std::vector<HalfEdgePair> pair_half_edges(const Draft& draft, const EdgeTopology& edges);

}  // namespace taxel
