#include "core/mesh/topology/half_edge_mesh.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text/number_text.h"

namespace taxel {
namespace {

void refuse(const TriMesh& mesh, int vertex, std::size_t count, const std::string& what) {
  const dvec3& p = mesh.vertices()[static_cast<std::size_t>(vertex)];
  throw Error("", "",
              fmt::format("must be a manifold: {} {}, the first at {}; repair the mesh first: "
                          "taxel mesh FILE --repair auto --out REPAIRED",
                          count, what, place_in_mm(p)));
}

void check_manifold(const TriMesh& mesh) {
  const EdgeTopology& edges = mesh.topology();
  const auto plural = [](std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; };
  if (const auto bad = edges.edges_of(EdgeKind::nonmanifold); !bad.empty())
    refuse(mesh, edges.low(bad[0][0]), bad.size(),
           plural(bad.size(), "edge with more than two faces", "edges with more than two faces"));
  if (const auto bad = edges.edges_of(EdgeKind::misoriented); !bad.empty())
    refuse(mesh, edges.low(bad[0][0]), bad.size(),
           plural(bad.size(), "edge whose faces wind differently", "edges whose faces wind differently"));
  if (const auto bad = edges.nonmanifold_vertices(); !bad.empty())
    refuse(mesh, bad.front(), bad.size(), plural(bad.size(), "vertex where parts touch", "vertices where parts touch"));
}

}  // namespace

HalfEdgeMesh to_half_edges(const TriMesh& mesh) {
  check_manifold(mesh);
  HalfEdgeMesh out;
  std::vector<OpenMesh::VertexHandle> handles;
  handles.reserve(mesh.vertices().size());
  for (const dvec3& p : mesh.vertices()) handles.push_back(out.add_vertex({p.x, p.y, p.z}));
  const auto at = [&](int vertex) { return handles[static_cast<std::size_t>(vertex)]; };
  for (const ivec3& face : mesh.faces())
    if (!out.add_face(at(face.x), at(face.y), at(face.z)).is_valid())
      throw Error("", fmt::format("face ({}, {}, {})", face.x, face.y, face.z), "does not fit its neighbours");
  return out;
}

TriMesh from_half_edges(const HalfEdgeMesh& mesh) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  vertices.reserve(mesh.n_vertices());
  faces.reserve(mesh.n_faces());
  for (const auto vertex : mesh.vertices()) {
    const OpenMesh::Vec3d& p = mesh.point(vertex);
    vertices.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto face : mesh.faces()) {
    ivec3 corners(0);
    int c = 0;
    for (const auto vertex : mesh.fv_range(face)) corners[c++] = vertex.idx();
    faces.push_back(corners);
  }
  return TriMesh(std::move(vertices), std::move(faces));
}

}  // namespace taxel
