// A triangle mesh as OpenMesh's half-edge structure, in double precision, for algorithms that change its topology.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Vertices and faces in their order. Throws Error that names the first edge or vertex that no half-edge structure can
/// have: more than two faces at an edge, two faces of different winding, several fans at a vertex.
HalfEdgeMesh to_half_edges(const TriMesh& mesh);

/// Vertices and faces in their order; those marked as deleted must have been collected.
TriMesh from_half_edges(const HalfEdgeMesh& mesh);

}  // namespace taxel
