#include "core/mesh/topology/decimate.h"

#include <fmt/format.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/topology/half_edge_mesh.h"

namespace taxel {
namespace {

constexpr float kMaxTurnDeg = 60;  ///< largest turn of a face by one collapse; larger ones fold the surface

using QuadricBase = OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>;

/// The quadric error, at least 0. On flat faces rounding makes it slightly negative, which OpenMesh takes for illegal:
/// flat faces would then keep vertices, and corners would go instead.
class QuadricError : public QuadricBase {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<QuadricError>;
  /// Without a largest error: the number of faces ends the decimation.
  explicit QuadricError(HalfEdgeMesh& mesh) : QuadricBase(mesh) { unset_max_err(); }
  float collapse_priority(const CollapseInfo& info) override {
    const float error = QuadricBase::collapse_priority(info);
    return error > static_cast<float>(ILLEGAL_COLLAPSE) ? std::max(error, 0.0F) : error;
  }
};

/// Moves the mesh to the origin and to size 1, where rounding errors of quadrics are small.
void normalize_size(HalfEdgeMesh& mesh, const Aabb& bounds) {
  const dvec3 c = bounds.center();
  const double scale = 1 / bounds.diagonal();
  for (const auto vertex : mesh.vertices())
    mesh.set_point(vertex, (mesh.point(vertex) - OpenMesh::Vec3d(c.x, c.y, c.z)) * scale);
}

/// Locks rims, because no faces across them have quadrics that would keep them in place.
void lock_rims(HalfEdgeMesh& mesh) {
  for (const auto vertex : mesh.vertices())
    if (mesh.is_boundary(vertex)) mesh.status(vertex).set_locked(true);
}

/// Returns the remaining faces between the original vertices of `mesh`.
TriMesh with_own_vertices(const HalfEdgeMesh& half_edges, const TriMesh& mesh) {
  std::vector<int> number(mesh.vertices().size(), -1);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (const auto vertex : half_edges.vertices()) {
    if (half_edges.status(vertex).deleted()) continue;
    number[static_cast<std::size_t>(vertex.idx())] = static_cast<int>(vertices.size());
    vertices.push_back(mesh.vertices()[static_cast<std::size_t>(vertex.idx())]);
  }
  for (const auto face : half_edges.faces()) {
    if (half_edges.status(face).deleted()) continue;
    ivec3 corners(0);
    int c = 0;
    for (const auto vertex : half_edges.fv_range(face)) corners[c++] = number[static_cast<std::size_t>(vertex.idx())];
    faces.push_back(corners);
  }
  return TriMesh(std::move(vertices), std::move(faces));
}

}  // namespace

TriMesh decimate(const TriMesh& mesh, int faces) {
  if (faces < 1) throw Error("", "", fmt::format("must be decimated to 1 face or more, asked for are {}", faces));
  if (faces >= mesh.face_count())
    throw Error("", "", fmt::format("has {} faces: it cannot be decimated to {}", mesh.face_count(), faces));
  HalfEdgeMesh half_edges = to_half_edges(mesh);
  normalize_size(half_edges, mesh.bounds());
  half_edges.request_vertex_status();
  half_edges.request_edge_status();
  half_edges.request_halfedge_status();
  half_edges.request_face_status();
  half_edges.request_face_normals();
  half_edges.update_face_normals();
  lock_rims(half_edges);

  OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half_edges);
  QuadricError::Handle quadric;
  decimater.add(quadric);
  OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle flipping;
  decimater.add(flipping);
  decimater.module(flipping).set_max_normal_deviation(kMaxTurnDeg);
  if (!decimater.initialize()) throw Error("", "", "cannot be decimated");
  decimater.decimate_to_faces(0, static_cast<std::size_t>(faces));
  return with_own_vertices(half_edges, mesh);
}

}  // namespace taxel
