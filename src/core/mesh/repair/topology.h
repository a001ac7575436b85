// The half-edges of a draft, by OpenMesh: one vertex per fan of faces, so that every draft becomes a manifold.
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

/// Two sides of an edge across which the surface continues. They pass the edge in opposite directions.
struct SidePair {
  EdgeSide a, b;
};

/// Faces of OpenMesh have the numbers of the draft's faces. Where the draft is no orientable manifold it is cut open.
struct Topology {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<DraftTraits>;
  Mesh mesh;
  std::vector<int> vertex_of;  ///< point of the draft for each vertex of OpenMesh
};

/// Pairs at the edges of exactly two faces in opposite directions, in the order of edges.
std::vector<SidePair> plain_pairs(std::span<const EdgeSide> sides);
/// Joins the corners, 3 face + c, that meet across paired sides: each set is one fan of faces at a point.
DisjointSets join_corners(const Draft& draft, std::span<const SidePair> pairs);
/// Makes one vertex of each set of join_corners(). Every face is kept.
Topology make_topology(const Draft& draft, std::span<const SidePair> pairs);

/// Groups of faces that hang together across `pairs`, numbered by their first face. Returns how many there are.
int find_patches(const Draft& draft, std::span<const SidePair> pairs, std::vector<int>& patch_of_face);

}  // namespace taxel
