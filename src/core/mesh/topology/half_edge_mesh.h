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

/// Converts a mesh, in the order of its vertices and faces. Throws Error that names the first place if the mesh is not
/// a manifold: an edge of more than two faces or of faces that wind differently, or a vertex with several fans.
HalfEdgeMesh to_half_edges(const TriMesh& mesh);

/// Converts back, in the order of vertices and faces. Deleted items must have been removed by garbage_collection().
TriMesh from_half_edges(const HalfEdgeMesh& mesh);

}  // namespace taxel
