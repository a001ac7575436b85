#include "core/mesh/topology/halfedge.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>

#include "core/base/index.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/topology/edge_sides.h"

namespace taxel {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OmMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Corners of faces (3 face + corner) gathered into fans: one number per fan of faces around one vertex.
class Fans {
 public:
  explicit Fans(std::size_t corner_count) : corners_(corner_count) {}
  /// Two sides of one edge belong together: so do the corners at its ends.
  void join(const EdgeSide& s, const EdgeSide& t) {
    corners_.unite(3 * s.face + s.corner, 3 * t.face + (t.corner + 1) % 3);
    corners_.unite(3 * s.face + (s.corner + 1) % 3, 3 * t.face + t.corner);
  }
  int of(int face, int corner) { return corners_.find(3 * face + corner); }

 private:
  DisjointSets corners_;
};

/// The OpenMesh mesh: one vertex per fan, faces in order.
struct Built {
  OmMesh mesh;
  std::vector<int> vertex_of;  // ours, for each of OpenMesh's
};

OpenMesh::VertexHandle add_vertex(Built& built, const TriMesh& mesh, int vertex) {
  const dvec3& p = mesh.vertices()[at(vertex)];
  built.vertex_of.push_back(vertex);
  return built.mesh.add_vertex({p.x, p.y, p.z});
}

/// Around one vertex of one fan the faces lie in a row or in a ring, each joined to the next across an edge that both
/// pass in opposite directions. So no side is ever taken twice, and OpenMesh accepts every face.
Built build(const TriMesh& mesh, Fans& fans) {
  Built built;
  std::vector<OpenMesh::VertexHandle> vertex_of_fan(3 * at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::array<OpenMesh::VertexHandle, 3> corners;
    for (int c = 0; c < 3; ++c) {
      OpenMesh::VertexHandle& handle = vertex_of_fan[at(fans.of(f, c))];
      if (!handle.is_valid()) handle = add_vertex(built, mesh, mesh.faces()[at(f)][c]);
      corners[at(c)] = handle;
    }
    built.mesh.add_face(corners[0], corners[1], corners[2]);
  }
  return built;
}

/// Signed angle between the normals of the two faces at an edge: by the sine along the edge and the cosine.
double dihedral(const TriMesh& mesh, const MeshEdge& edge) {
  const dvec3 &left = mesh.face_normals()[at(edge.left)], &right = mesh.face_normals()[at(edge.right)];
  const dvec3 along = glm::normalize(mesh.vertices()[at(edge.b)] - mesh.vertices()[at(edge.a)]);
  return std::atan2(glm::dot(glm::cross(left, right), along), glm::dot(left, right));
}

int corner_of(const TriMesh& mesh, int face, int vertex) {
  const ivec3& ids = mesh.faces()[at(face)];
  return ids.x == vertex ? 0 : ids.y == vertex ? 1 : 2;
}

/// Two of the faces at a non-manifold edge may lie in the same fans at both of its ends: there too nothing is joined.
std::vector<ivec3> all_neighbours(const Built& built, const TriMesh& mesh, const std::vector<BadEdge>& cuts) {
  std::vector<ivec3> neighbours(mesh.faces().size(), ivec3(-1));
  for (const OpenMesh::SmartHalfedgeHandle h : built.mesh.halfedges()) {
    if (h.is_boundary()) continue;
    const int face = h.face().idx();
    neighbours[at(face)][corner_of(mesh, face, built.vertex_of[at(h.from().idx())])] = h.opp().face().idx();
  }
  for (const BadEdge& cut : cuts) {
    for (const int face : cut.faces) {
      const int a = corner_of(mesh, face, cut.a), b = corner_of(mesh, face, cut.b);
      neighbours[at(face)][(a + 1) % 3 == b ? a : b] = -1;
    }
  }
  return neighbours;
}

std::vector<MeshEdge> all_edges(const Built& built, const TriMesh& mesh, const std::vector<ivec3>& neighbours) {
  std::vector<MeshEdge> edges;
  for (const OpenMesh::SmartEdgeHandle e : built.mesh.edges()) {
    for (const OpenMesh::SmartHalfedgeHandle h : {e.h0(), e.h1()}) {
      if (h.is_boundary()) continue;
      MeshEdge edge{built.vertex_of[at(h.from().idx())], built.vertex_of[at(h.to().idx())], h.face().idx(), -1, 0.0};
      edge.right = neighbours[at(edge.left)][corner_of(mesh, edge.left, edge.a)];
      if (edge.right >= 0) edge.dihedral = dihedral(mesh, edge);
      edges.push_back(edge);
      if (edge.right >= 0) break;  // both sides are said
    }
  }
  return edges;
}

}  // namespace

HalfEdges::HalfEdges(const TriMesh& mesh) {
  const std::vector<EdgeSide> all_sides = edge_sides(mesh);
  Fans fans(all_sides.size());
  for_each_edge(all_sides, [&](std::span<const EdgeSide> sides) {
    const EdgeSide& first = sides[0];
    BadEdge bad{first.low, first.high, {}};
    for (const EdgeSide& side : sides) bad.faces.push_back(side.face);
    if (sides.size() > 2) {
      nonmanifold_.push_back(bad);
    } else if (sides.size() == 1) {
      boundary_.emplace_back(first.forward ? first.low : first.high, first.forward ? first.high : first.low);
    } else if (first.forward == sides[1].forward) {
      misoriented_.push_back(bad);
    } else {
      fans.join(first, sides[1]);
    }
  });
  const Built built = build(mesh, fans);
  neighbours_ = all_neighbours(built, mesh, nonmanifold_);
  edges_ = all_edges(built, mesh, neighbours_);
  rings_.resize(mesh.vertices().size());
  std::vector<int> fan_count(mesh.vertices().size(), 0);
  for (const OpenMesh::SmartVertexHandle v : built.mesh.vertices()) {
    if (built.mesh.is_isolated(v)) continue;
    const int vertex = built.vertex_of[at(v.idx())];
    if (++fan_count[at(vertex)] == 2) split_vertices_.push_back(vertex);
    for (const OpenMesh::SmartVertexHandle w : v.vertices_ccw())
      rings_[at(vertex)].push_back(built.vertex_of[at(w.idx())]);
  }
  std::sort(split_vertices_.begin(), split_vertices_.end());
}

}  // namespace taxel
