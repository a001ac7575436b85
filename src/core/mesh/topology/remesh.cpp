// Subdivision and decimation on the half-edges of OpenMesh.
//
// Decimation collapses the edge with the least quadric error first: the sum of the squared distances to the planes of
// the faces that a vertex has replaced. Collapses that turn a face by more than 60 degrees are not allowed, since they
// fold the surface. Meshes that are no manifold are refused with the first place, because its half-edges cannot hold
// them.
//
// Pitfall: on flat faces rounding makes the error slightly negative, which OpenMesh takes for a forbidden collapse.
// Flat faces would then keep their vertices and corners would go instead, so the error is at least 0.
#include "core/mesh/topology/remesh.h"

#include <fmt/format.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text/message.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {
namespace {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

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

/// Converts a mesh, in the order of its vertices and faces. Throws Error that names the first place if the mesh is not
/// a manifold: an edge of more than two faces or of faces that wind differently, or a vertex with several fans.
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

/// Converts back, in the order of vertices and faces. Deleted items must have been removed by garbage_collection().
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

}  // namespace

TriMesh subdivide(const TriMesh& mesh, int times, SubdivisionScheme scheme) {
  if (times < 1) throw Error("", "", fmt::format("must be subdivided 1 time or more, asked for are {}", times));
  double faces = mesh.face_count();
  for (int i = 0; i < times && faces <= static_cast<double>(kMaxSubdividedFaces); ++i) faces *= 4;
  if (faces > static_cast<double>(kMaxSubdividedFaces))
    throw Error("", "",
                fmt::format("has {} faces: subdivided {} times it has more than {}", mesh.face_count(), times,
                            kMaxSubdividedFaces));
  HalfEdgeMesh half_edges = to_half_edges(mesh);
  OpenMesh::Subdivider::Uniform::LoopT<HalfEdgeMesh, double> splitter;
  splitter.attach(half_edges);
  // Without moved vertices Loop's split is the midpoint scheme.
  splitter(static_cast<std::size_t>(times), scheme == SubdivisionScheme::loop);
  splitter.detach();
  half_edges.garbage_collection();
  return from_half_edges(half_edges);
}

namespace {

constexpr float kMaxTurnDeg = 60;  ///< largest turn of a face by one collapse; larger ones fold the surface

using QuadricBase = OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>;

/// The quadric error, at least 0.
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
