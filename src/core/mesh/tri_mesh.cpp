#include "core/mesh/tri_mesh.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/angle.h"
#include "core/base/error.h"
#include "core/base/index.h"
#include "core/mesh/query/disjoint_sets.h"

namespace taxel {
namespace {

/// Throws Error naming the first vertex or face that is not valid.
void check_input(const std::vector<dvec3>& vertices, const std::vector<ivec3>& faces) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!is_finite(vertices[v])) throw Error(fmt::format("vertex {}: coordinate is not finite", v));
  }
  const int n = static_cast<int>(vertices.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const ivec3& face = faces[f];
    for (int c = 0; c < 3; ++c) {
      if (face[c] < 0 || face[c] >= n) throw Error(fmt::format("face {}: no vertex {} (there are {})", f, face[c], n));
    }
    if (face.x == face.y || face.y == face.z || face.z == face.x)
      throw Error(fmt::format("face {}: two of its corners are the same vertex", f));
  }
}

/// Finds shells of faces that share vertices, numbered by their first face. Returns the number of shells.
int find_shells(int vertex_count, const std::vector<ivec3>& faces, std::vector<int>& shell_of_face) {
  DisjointSets sets(at(vertex_count));
  for (const ivec3& f : faces) {
    sets.unite(f.x, f.y);
    sets.unite(f.x, f.z);
  }
  std::vector<int> number(at(vertex_count), -1);
  shell_of_face.resize(faces.size());
  int count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    int& shell = number[at(sets.find(faces[f].x))];
    if (shell < 0) shell = count++;
    shell_of_face[f] = shell;
  }
  return count;
}

}  // namespace

TriMesh::TriMesh(std::vector<dvec3> vertices, std::vector<ivec3> faces, std::vector<ivec3> flat_faces)
    : vertices_(std::move(vertices)), flat_faces_(std::move(flat_faces)) {
  check_input(vertices_, faces);
  check_input(vertices_, flat_faces_);
  topology_ = EdgeTopology(std::move(faces), vertices_.size());
  for (const dvec3& v : vertices_) bounds_.include(v);
  compute_normals();
  compute_integrals();
  shell_count_ = find_shells(vertex_count(), topology_.faces(), shell_of_face_);
  if (!closed() || std::abs(volume_) <= std::numeric_limits<double>::epsilon() * area_ * bounds_.diagonal())
    centroid_ = area_centroid();
}

void TriMesh::compute_normals() {
  face_normals_.resize(faces().size());
  face_areas_.resize(faces().size());
  vertex_normals_.assign(vertices_.size(), dvec3(0));
  for (int f = 0; f < face_count(); ++f) {
    const dvec3 &a = vertex(f, 0), &b = vertex(f, 1), &c = vertex(f, 2);
    const dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    if (!(length > 0)) throw Error(fmt::format("face {}: has no area", f));
    face_areas_[at(f)] = 0.5 * length;
    face_normals_[at(f)] = n / length;
    area_ += 0.5 * length;
    // Angle weights (Thuermer, Wuethrich 1998): the normal does not depend on the triangulation around the vertex.
    const ivec3& ids = faces()[at(f)];
    vertex_normals_[at(ids.x)] += angle_between(b - a, c - a) * face_normals_[at(f)];
    vertex_normals_[at(ids.y)] += angle_between(c - b, a - b) * face_normals_[at(f)];
    vertex_normals_[at(ids.z)] += angle_between(a - c, b - c) * face_normals_[at(f)];
  }
  for (dvec3& n : vertex_normals_) {
    const double length = glm::length(n);
    n = length > 0 ? n / length : dvec3(0, 0, 1);  // any normal if no faces are there or they cancel out
  }
}

void TriMesh::compute_integrals() {
  // Divergence theorem: tetrahedra from one apex to every face; the apex in the middle keeps the rounding small.
  const dvec3 apex = bounds_.empty() ? dvec3(0) : bounds_.center();
  dvec3 moment{0};
  for (int f = 0; f < face_count(); ++f) {
    const dvec3 a = vertex(f, 0) - apex, b = vertex(f, 1) - apex, c = vertex(f, 2) - apex;
    const double tet = glm::dot(a, glm::cross(b, c)) / 6.0;
    volume_ += tet;
    moment += tet * 0.25 * (a + b + c);
  }
  centroid_ = volume_ != 0 ? apex + moment / volume_ : apex;
}

dvec3 TriMesh::area_centroid() const {
  dvec3 sum{0};
  for (int f = 0; f < face_count(); ++f) sum += face_areas_[at(f)] * (vertex(f, 0) + vertex(f, 1) + vertex(f, 2)) / 3.0;
  return area_ > 0 ? sum / area_ : dvec3(0);
}

TriMesh extract_shells(const TriMesh& mesh, const std::vector<int>& shells, std::vector<int>* face_of) {
  std::vector<char> wanted(at(mesh.shell_count()), 0);
  for (const int s : shells) {
    if (s < 0 || s >= mesh.shell_count()) throw Error(fmt::format("no shell {} (there are {})", s, mesh.shell_count()));
    wanted[at(s)] = 1;
  }
  std::vector<int> faces;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (wanted[at(mesh.shell_of_face()[at(f)])]) faces.push_back(f);
  TriMesh extracted = extract_faces(mesh, faces);
  if (face_of != nullptr) *face_of = std::move(faces);
  return extracted;
}

TriMesh extract_faces(const TriMesh& mesh, const std::vector<int>& wanted) {
  std::vector<int> new_index(mesh.vertices().size(), -1);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (const int f : wanted) {
    ivec3 face{0};
    for (int c = 0; c < 3; ++c) {
      int& index = new_index[at(mesh.faces()[at(f)][c])];
      if (index < 0) {
        index = static_cast<int>(vertices.size());
        vertices.push_back(mesh.vertex(f, c));
      }
      face[c] = index;
    }
    faces.push_back(face);
  }
  return {std::move(vertices), std::move(faces)};
}

}  // namespace taxel
