#include "core/mesh/query/self_intersection.h"

#include <optional>

#include "core/base/index.h"
#include "core/base/parallel.h"

namespace taxel {
namespace {

/// Six times the volume of the tet a b c d, and the size of its terms, which bounds the rounding error.
struct Orientation {
  double volume, scale;
  Orientation(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    const dvec3 u = b - a, v = c - a, w = d - a;
    volume = glm::dot(glm::cross(u, v), w);
    scale = glm::length(u) * glm::length(v) * glm::length(w);
  }
  [[nodiscard]] int sign() const {
    constexpr double kRounding = 1e-12;
    return std::abs(volume) <= kRounding * scale ? 0 : volume > 0 ? 1 : -1;
  }
};

/// Returns the point at which the open segment p q goes through the inside of the triangle a b c: the ends of the
/// segment are on different sides of the triangle, and the segment passes all edges on the same side.
std::optional<dvec3> crossing(const dvec3& p, const dvec3& q, const dvec3& a, const dvec3& b, const dvec3& c) {
  const Orientation above(a, b, c, p), below(a, b, c, q);
  if (above.sign() * below.sign() >= 0) return std::nullopt;
  const int side = Orientation(p, q, a, b).sign();
  if (side == 0 || Orientation(p, q, b, c).sign() != side || Orientation(p, q, c, a).sign() != side)
    return std::nullopt;
  const double t = above.volume / (above.volume - below.volume);
  return p + t * (q - p);
}

bool share_vertex(const ivec3& f, const ivec3& g) {
  for (int c = 0; c < 3; ++c) {
    if (f[c] == g.x || f[c] == g.y || f[c] == g.z) return true;
  }
  return false;
}

std::optional<dvec3> crossing(const TriMesh& mesh, int f, int g) {
  for (const auto& [edges, face] : {std::pair(f, g), std::pair(g, f)}) {
    for (int c = 0; c < 3; ++c) {
      const auto place = crossing(mesh.vertex(edges, c), mesh.vertex(edges, (c + 1) % 3), mesh.vertex(face, 0),
                                  mesh.vertex(face, 1), mesh.vertex(face, 2));
      if (place) return place;
    }
  }
  return std::nullopt;
}

Aabb box_of_face(const TriMesh& mesh, int f) {
  Aabb box;
  for (int c = 0; c < 3; ++c) box.include(mesh.vertex(f, c));
  return box;
}

/// Finds pairs of faces f < g with begin <= f < end.
SelfIntersections find_in_range(const TriMesh& mesh, const BoxTree& tree, int begin, int end) {
  SelfIntersections found;
  for (int f = begin; f < end; ++f) {
    const Aabb box = box_of_face(mesh, f);
    tree.visit_overlapping(box, [&](int g) {
      if (g <= f || share_vertex(mesh.faces()[at(f)], mesh.faces()[at(g)])) return;
      if (!box_of_face(mesh, g).overlaps(box)) return;
      const auto place = crossing(mesh, f, g);
      if (!place) return;
      const bool first = found.pairs++ == 0 || (f == found.face_a && g < found.face_b);
      if (!first) return;
      found.face_a = f;
      found.face_b = g;
      found.place = *place;
    });
  }
  return found;
}

}  // namespace

SelfIntersections find_self_intersections(const TriMesh& mesh) {
  return find_self_intersections(mesh, tree_of_faces(mesh));
}

SelfIntersections find_self_intersections(const TriMesh& mesh, const BoxTree& tree) {
  constexpr int kChunk = 256;
  std::vector<SelfIntersections> of_chunk(mesh.faces().size() / kChunk + 1);
  parallel_chunks(mesh.face_count(), kChunk,
                  [&](int begin, int end) { of_chunk[at(begin / kChunk)] = find_in_range(mesh, tree, begin, end); });
  SelfIntersections found;
  for (const SelfIntersections& part : of_chunk) {
    const int pairs = found.pairs + part.pairs;
    if (found.pairs == 0) found = part;
    found.pairs = pairs;
  }
  return found;
}

}  // namespace taxel
