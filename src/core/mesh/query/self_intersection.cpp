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

/// Triangles over shared points.
struct Triangles {
  const std::vector<dvec3>& points;
  const std::vector<ivec3>& faces;
  [[nodiscard]] int count() const { return static_cast<int>(faces.size()); }
  [[nodiscard]] const dvec3& corner(int f, int c) const { return points[at(faces[at(f)][c])]; }
  [[nodiscard]] Aabb box(int f) const {
    Aabb box;
    for (int c = 0; c < 3; ++c) box.include(corner(f, c));
    return box;
  }
};

std::optional<dvec3> crossing(const Triangles& triangles, int f, int g) {
  for (const auto& [edges, face] : {std::pair(f, g), std::pair(g, f)}) {
    for (int c = 0; c < 3; ++c) {
      const auto place = crossing(triangles.corner(edges, c), triangles.corner(edges, (c + 1) % 3),
                                  triangles.corner(face, 0), triangles.corner(face, 1), triangles.corner(face, 2));
      if (place) return place;
    }
  }
  return std::nullopt;
}

constexpr int kChunk = 256;

/// Finds pairs of faces f < g with begin <= f < end.
SelfIntersections find_in_range(const Triangles& triangles, const BoxTree& tree, int begin, int end) {
  SelfIntersections found;
  for (int f = begin; f < end; ++f) {
    const Aabb box = triangles.box(f);
    tree.visit_overlapping(box, [&](int g) {
      if (g <= f || share_vertex(triangles.faces[at(f)], triangles.faces[at(g)])) return;
      if (!triangles.box(g).overlaps(box)) return;
      const auto place = crossing(triangles, f, g);
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
  return find_self_intersections(mesh, tree_of_faces(mesh, Bvh::Effort::few_queries));
}

SelfIntersections find_self_intersections(const TriMesh& mesh, const BoxTree& tree) {
  std::vector<SelfIntersections> of_chunk(mesh.faces().size() / kChunk + 1);
  const Triangles triangles{mesh.vertices(), mesh.faces()};
  parallel_chunks(mesh.face_count(), kChunk, [&](int begin, int end) {
    of_chunk[at(begin / kChunk)] = find_in_range(triangles, tree, begin, end);
  });
  SelfIntersections found;
  for (const SelfIntersections& part : of_chunk) {
    const int pairs = found.pairs + part.pairs;
    if (found.pairs == 0) found = part;
    found.pairs = pairs;
  }
  return found;
}

std::vector<std::pair<int, int>> find_crossing_pairs(const std::vector<dvec3>& points, const std::vector<ivec3>& faces,
                                                     const std::vector<char>& chosen) {
  const Triangles triangles{points, faces};
  std::vector<int> list;
  std::vector<Aabb> boxes;
  Aabb all;
  for (int f = 0; f < triangles.count(); ++f) {
    if (chosen[at(f)] == 0) continue;
    list.push_back(f);
    boxes.push_back(triangles.box(f));
    all.include(boxes.back());
  }
  const BoxTree tree(boxes, Bvh::Effort::few_queries);
  std::vector<std::vector<std::pair<int, int>>> of_chunk(faces.size() / kChunk + 1);
  parallel_chunks(triangles.count(), kChunk, [&](int begin, int end) {
    auto& pairs = of_chunk[at(begin / kChunk)];
    for (int f = begin; f < end; ++f) {
      const Aabb box = triangles.box(f);
      if (!box.overlaps(all)) continue;
      tree.visit_overlapping(box, [&](int i) {
        const int g = list[at(i)];
        const bool comes_twice = chosen[at(f)] != 0 && g <= f;
        if (comes_twice || share_vertex(faces[at(f)], faces[at(g)]) || !triangles.box(g).overlaps(box)) return;
        if (crossing(triangles, f, g)) pairs.push_back(std::minmax(f, g));
      });
    }
  });
  std::vector<std::pair<int, int>> pairs;
  for (const auto& part : of_chunk) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace taxel
