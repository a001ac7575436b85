// The edges of a mesh, its derived values, parts of it, and cuts with planes.
//
// Half-edges are grouped into edges by sorting: by counting over their lower vertex, and then the few at one vertex by
// the higher vertex. One 64-bit key holds the higher vertex, the half-edge and its direction, so equal edges are
// neighbours in the order of their faces. This is linear in practice, takes any triangles, and leaves half-edges
// without a twin where an edge is no inner one.
//
// Volume and centroid are sums over tets between the faces and the middle of the box, which keeps rounding small
// (divergence theorem). Vertex normals are weighted by angles (Thuermer, Wuethrich 1998), so they do not depend on the
// triangulation around a vertex. Points of a cut are computed from the lower vertex of their edge, so both faces get
// equal bits.
#include "core/mesh/tri_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/mesh/query/disjoint_sets.h"

namespace taxel {

/// The last bit of a key is 1 if the half-edge is forward.
EdgeTopology::EdgeTopology(std::vector<ivec3> faces, std::size_t vertex_count)
    : faces_(std::move(faces)), half_edges_(3 * faces_.size()), twins_(half_edges_.size(), -1) {
  std::vector<std::size_t> next(vertex_count + 1, 0);  // next[v]: place of the next key with the lower vertex v
  for (const ivec3& f : faces_)
    for (const int low : {std::min(f.x, f.y), std::min(f.y, f.z), std::min(f.z, f.x)}) ++next[at(low) + 1];
  for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
  std::vector<std::uint64_t> keys(half_edges_.size());
  std::uint64_t h = 0;
  for (const ivec3& f : faces_) {
    for (const auto& [a, b] : {std::pair(f.x, f.y), std::pair(f.y, f.z), std::pair(f.z, f.x)}) {
      const auto high = static_cast<std::uint64_t>(std::max(a, b));
      keys[next[at(std::min(a, b))]++] = high << 32 | h++ << 1 | (a < b ? 1U : 0U);
    }
  }
  first_.reserve(1 + 2 * faces_.size());
  for (std::size_t v = 0, begin = 0; v < vertex_count; begin = next[v++]) {  // next[v] is the end of v's keys now
    std::sort(keys.begin() + static_cast<std::ptrdiff_t>(begin), keys.begin() + static_cast<std::ptrdiff_t>(next[v]));
    for (std::size_t i = begin, end = begin; i < next[v]; i = end) {
      for (; end < next[v] && keys[end] >> 32 == keys[i] >> 32; ++end)
        half_edges_[end] = static_cast<int>((keys[end] & 0xffffffffU) >> 1);
      first_.push_back(static_cast<int>(end));
      if (end - i != 2 || (keys[i] & 1U) == (keys[i + 1] & 1U)) continue;
      twins_[at(half_edges_[i])] = half_edges_[i + 1];
      twins_[at(half_edges_[i + 1])] = half_edges_[i];
    }
  }
  closed_ = !faces_.empty() && std::find(twins_.begin(), twins_.end(), -1) == twins_.end();
}

std::span<const int> EdgeTopology::edge_between(int a, int b) const {
  using Ends = std::pair<int, int>;
  const Ends wanted(std::min(a, b), std::max(a, b));
  const auto ends = [&](int first) { return Ends(low(half_edges_[at(first)]), high(half_edges_[at(first)])); };
  const auto found = std::lower_bound(first_.begin(), first_.end() - 1, wanted,
                                      [&](int first, const Ends& value) { return ends(first) < value; });
  if (found == first_.end() - 1 || ends(*found) != wanted) return {};
  return edge(static_cast<int>(found - first_.begin()));
}

EdgeKind EdgeTopology::kind(std::span<const int> edge) const {
  if (edge.size() == 1) return EdgeKind::boundary;
  if (edge.size() > 2) return EdgeKind::nonmanifold;
  return twin(edge[0]) < 0 ? EdgeKind::misoriented : EdgeKind::inner;
}

std::vector<std::span<const int>> EdgeTopology::edges_of(EdgeKind wanted) const {
  std::vector<std::span<const int>> edges;
  for_each_edge([&](std::span<const int> edge) {
    if (kind(edge) == wanted) edges.push_back(edge);
  });
  return edges;
}

VertexFans EdgeTopology::vertex_fans() const {
  VertexFans fans{std::vector<int>(twins_.size(), -1), {}, {0}};
  fans.corners.reserve(twins_.size());
  for (int h = 0; h < half_edge_count(); ++h) {
    if (fans.fan_of[at(h)] >= 0) continue;
    // Clockwise to the boundary, if there is one: to the face across the half-edge that begins at the vertex.
    int begin = h;
    do {
      const int across = twin(begin);
      if (across < 0) break;
      begin = next_edge(across);
    } while (begin != h);
    // Counter-clockwise: to the face across the half-edge that ends at the vertex.
    int corner = begin;
    do {
      fans.fan_of[at(corner)] = fans.count();
      fans.corners.push_back(corner);
      corner = twin(previous_edge(corner));
    } while (corner >= 0 && corner != begin);
    fans.first.push_back(static_cast<int>(fans.corners.size()));
  }
  return fans;
}

std::vector<int> EdgeTopology::nonmanifold_vertices() const {
  std::vector<int> vertices;
  const VertexFans fans = vertex_fans();
  for (int fan = 0; fan < fans.count(); ++fan) vertices.push_back(from(fans.corners_of(fan)[0]));
  std::sort(vertices.begin(), vertices.end());
  // Keeps one entry of each vertex that is listed more than once.
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < vertices.size(); begin = end) {
    while (end < vertices.size() && vertices[end] == vertices[begin]) ++end;
    if (end - begin > 1) vertices[kept++] = vertices[begin];
  }
  vertices.resize(kept);
  return vertices;
}

std::vector<std::vector<int>> EdgeTopology::boundary_loops() const {
  std::vector<std::vector<int>> loops;
  std::vector<char> is_listed(twins_.size(), 0);
  for (int first = 0; first < half_edge_count(); ++first) {
    if (twin(first) >= 0 || is_listed[at(first)] != 0) continue;
    std::vector<int>& loop = loops.emplace_back();
    int h = first;
    do {
      is_listed[at(h)] = 1;
      loop.push_back(h);
      for (h = next_edge(h); twin(h) >= 0;) h = next_edge(twin(h));
    } while (h != first);
  }
  return loops;
}

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

std::vector<std::pair<dvec3, dvec3>> slice_mesh(const TriMesh& mesh, const dvec3& point, const dvec3& normal) {
  std::vector<double> height;
  height.reserve(mesh.vertices().size());
  for (const dvec3& v : mesh.vertices()) height.push_back(glm::dot(v - point, normal));
  const auto above = [&](int v) { return height[at(v)] >= 0; };
  // The point of edge a b on the plane.
  const auto crossing = [&](int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const double part = height[at(low)] / (height[at(low)] - height[at(high)]);
    return glm::mix(mesh.vertices()[at(low)], mesh.vertices()[at(high)], part);
  };
  std::vector<std::pair<dvec3, dvec3>> segments;
  for (const ivec3& f : mesh.faces()) {
    for (int c = 0; c < 3; ++c) {
      // Only a corner that is alone on its side of the plane gives a segment.
      const int alone = f[c], next = f[(c + 1) % 3], last = f[(c + 2) % 3];
      if (above(alone) == above(next) || above(alone) == above(last)) continue;
      const dvec3 out = crossing(alone, next), in = crossing(alone, last);
      segments.push_back(above(alone) ? std::pair(out, in) : std::pair(in, out));
    }
  }
  return segments;
}

}  // namespace taxel
