#include "core/mesh/halfedge.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>

#include "core/mesh/disjoint_sets.h"
#include "core/mesh/edge_sides.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

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
    // A fan that closes on itself through a bad edge can still offer a taken side: such a face stands alone.
    bool taken = false;
    for (int c = 0; c < 3; ++c) {
      const auto side = built.mesh.find_halfedge(corners[at(c)], corners[at((c + 1) % 3)]);
      taken = taken || (side.is_valid() && !built.mesh.is_boundary(side));
      taken = taken || !built.mesh.is_boundary(corners[at(c)]);
    }
    if (taken) {
      for (int c = 0; c < 3; ++c) corners[at(c)] = add_vertex(built, mesh, mesh.faces()[at(f)][c]);
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

std::vector<MeshEdge> all_edges(const Built& built, const TriMesh& mesh) {
  std::vector<MeshEdge> edges;
  for (const OpenMesh::SmartEdgeHandle e : built.mesh.edges()) {
    const OpenMesh::SmartHalfedgeHandle h = e.h0().is_boundary() ? e.h1() : e.h0();
    MeshEdge edge{built.vertex_of[at(h.from().idx())], built.vertex_of[at(h.to().idx())], h.face().idx(),
                  h.opp().face().idx(), 0.0};
    if (edge.right >= 0) edge.dihedral = dihedral(mesh, edge);
    edges.push_back(edge);
  }
  return edges;
}

std::vector<ivec3> all_neighbours(const Built& built, const TriMesh& mesh) {
  std::vector<ivec3> neighbours(mesh.faces().size(), ivec3(-1));
  for (const OpenMesh::SmartFaceHandle f : built.mesh.faces()) {
    const ivec3& ids = mesh.faces()[at(f.idx())];
    for (const OpenMesh::SmartHalfedgeHandle h : f.halfedges()) {
      const int from = built.vertex_of[at(h.from().idx())];
      const int corner = ids.x == from ? 0 : ids.y == from ? 1 : 2;
      neighbours[at(f.idx())][corner] = h.opp().face().idx();
    }
  }
  return neighbours;
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
  edges_ = all_edges(built, mesh);
  neighbours_ = all_neighbours(built, mesh);
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
