// Pairs of triangles that cut through each other.
//
// Two triangles without a common vertex cross if an edge of one goes through the inside of the other: its ends are on
// different sides of the plane, and it passes the three edges on the same side. All of these are signs of volumes of
// tets. A volume that rounding alone can have made has no sign, so triangles that only touch, or lie in one plane, do
// not cross.
//
// Pairs come from a tree of boxes. The faces of one node are tested together, which visits the tree half as often, and
// nearly all pairs end with the first three volumes: all corners of one triangle are clearly on one side of the other.
// Cost: O(n log n) if few boxes overlap; where most faces cross others, the searches with a limit, or for faces instead
// of pairs, end early. Results are the same for any number of threads.
#include "core/mesh/query/self_intersection.h"

#include <atomic>
#include <optional>

#include "core/base/math.h"
#include "core/base/parallel.h"

namespace taxel {
namespace {

/// The plane of a triangle a b c, as the sign of the volume of the tet a b c x for each point x.
class Plane {
 public:
  Plane(const dvec3& a, const dvec3& b, const dvec3& c) : a_(a), u_(b - a), v_(c - a), normal_(glm::cross(u_, v_)) {}

  /// Six times the volume of the tet.
  [[nodiscard]] double volume(const dvec3& x) const { return glm::dot(normal_, x - a_); }
  /// The side of x: the sign of its volume, or 0 if rounding alone can have made that. No volume above `clear`, which
  /// is that of clear_volume(), is made by rounding: most points need no roots.
  [[nodiscard]] int side(const dvec3& x, double volume, double clear) const {
    if (std::abs(volume) > clear) return volume > 0 ? 1 : -1;
    const double scale = glm::length(u_) * glm::length(v_) * glm::length(x - a_);
    return std::abs(volume) <= kRounding * scale ? 0 : volume > 0 ? 1 : -1;
  }
  /// A volume that rounding cannot make if the points are in boxes that overlap, `length` being the sum of all extents.
  static double clear_volume(double length) { return 2 * kRounding * length * length * length; }

 private:
  static constexpr double kRounding = 1e-12;  ///< largest rounding error of a volume, relative to its terms
  dvec3 a_, u_, v_, normal_;
};

/// The side of the line p q on which the edge a b is.
int side_of(const dvec3& p, const dvec3& q, const dvec3& a, const dvec3& b, double clear) {
  const Plane plane(p, q, a);
  return plane.side(b, plane.volume(b), clear);
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

/// The corners of a triangle relative to the plane of another one.
struct Sides {
  double volume[3];
  int side[3] = {0, 0, 0};

  Sides(const Plane& plane, const Triangles& triangles, int f) {
    for (int c = 0; c < 3; ++c) volume[c] = plane.volume(triangles.corner(f, c));
  }
  /// Returns true if all corners are clearly on one side: most triangles are.
  [[nodiscard]] bool are_one(double clear) const {
    return std::min({volume[0], volume[1], volume[2]}) > clear || std::max({volume[0], volume[1], volume[2]}) < -clear;
  }
  void find_sides(const Plane& plane, const Triangles& triangles, int f, double clear) {
    for (int c = 0; c < 3; ++c) side[c] = plane.side(triangles.corner(f, c), volume[c], clear);
  }
};

/// Returns the point at which an edge of the triangle f goes through the inside of the triangle g: the ends of the edge
/// are on different sides of g, and the edge passes all edges of g on the same side.
std::optional<dvec3> edge_through(const Triangles& triangles, int f, int g, const Sides& of_f, double clear) {
  const dvec3 &a = triangles.corner(g, 0), &b = triangles.corner(g, 1), &c = triangles.corner(g, 2);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (of_f.side[i] * of_f.side[next] >= 0) continue;
    const dvec3 &p = triangles.corner(f, i), &q = triangles.corner(f, next);
    const int passed = side_of(p, q, a, b, clear);
    if (passed == 0 || side_of(p, q, b, c, clear) != passed || side_of(p, q, c, a, clear) != passed) continue;
    const double t = of_f.volume[i] / (of_f.volume[i] - of_f.volume[next]);
    return p + t * (q - p);
  }
  return std::nullopt;
}

/// A triangle that is tested against many others.
class TestedTriangle {
 public:
  TestedTriangle(const Triangles& triangles, int f)
      : triangles_(&triangles),
        f_(f),
        plane_(triangles.corner(f, 0), triangles.corner(f, 1), triangles.corner(f, 2)),
        box_(triangles.box(f)) {}

  [[nodiscard]] const Aabb& box() const { return box_; }
  [[nodiscard]] int face() const { return f_; }
  /// Returns a point on both triangles if they have no common vertex and an edge of one goes through the other.
  [[nodiscard]] std::optional<dvec3> crossing(int g) const { return crossing(g, triangles_->box(g)); }
  [[nodiscard]] std::optional<dvec3> crossing(int g, const Aabb& box_of_g) const {
    if (!box_of_g.overlaps(box_) || share_vertex(triangles_->faces[at(f_)], triangles_->faces[at(g)]))
      return std::nullopt;
    const double clear = Plane::clear_volume(length_ + length_of(box_of_g));
    Sides of_g(plane_, *triangles_, g);
    if (of_g.are_one(clear)) return std::nullopt;
    const Plane plane(triangles_->corner(g, 0), triangles_->corner(g, 1), triangles_->corner(g, 2));
    Sides of_f(plane, *triangles_, f_);
    if (of_f.are_one(clear)) return std::nullopt;
    of_f.find_sides(plane, *triangles_, f_, clear);
    const std::optional<dvec3> place = edge_through(*triangles_, f_, g, of_f, clear);
    if (place) return place;
    of_g.find_sides(plane_, *triangles_, g, clear);
    return edge_through(*triangles_, g, f_, of_g, clear);
  }

 private:
  static double length_of(const Aabb& box) {
    const dvec3 extent = box.extent();
    return extent.x + extent.y + extent.z;
  }

  const Triangles* triangles_;
  int f_;
  Plane plane_;
  Aabb box_;
  double length_ = length_of(box_);  ///< sum of the extents of the box [m]
};

constexpr int kChunk = 256;

/// Needs every face.
bool is_any(int /*face*/) {
  return true;
}

/// Calls test(tested f, g, box of g) for all faces f of the leaves of some nodes and all faces g whose boxes may
/// overlap theirs, until a test of f returns true. Neighbours are visited together, which takes half as long. Faces f
/// for which is_needed(f) is false are not tested.
template <class IsNeeded, class Test>
void test_neighbours(const Triangles& triangles, const BoxTree& tree, int begin, int end, const IsNeeded& is_needed,
                     const Test& test) {
  std::vector<TestedTriangle> tested;
  for (int node = begin; node < end; ++node) {
    const BoxTree::Leaves leaves = tree.leaves_of(node);
    tested.clear();
    Aabb box;
    for (int i = 0; i < leaves.count; ++i) {
      const int f = leaves.primitives[at(i)];
      if (!is_needed(f)) continue;
      tested.emplace_back(triangles, f);
      box.include(tested.back().box());
    }
    if (tested.empty()) continue;
    tree.visit_overlapping(box, [&](int g) {
      const Aabb box_of_g = triangles.box(g);
      std::erase_if(tested, [&](const TestedTriangle& f) { return test(f, g, box_of_g); });
      return tested.empty();
    });
  }
}

/// Finds the pairs of faces f < g with f in the leaves of some nodes.
SelfIntersections find_in_range(const Triangles& triangles, const BoxTree& tree, int begin, int end) {
  SelfIntersections found;
  const auto test = [&](const TestedTriangle& tested, int g, const Aabb& box) {
    const int f = tested.face();
    const auto place = g > f ? tested.crossing(g, box) : std::nullopt;
    if (!place) return false;
    const bool is_first = found.pairs++ == 0 || std::pair(f, g) < std::pair(found.face_a, found.face_b);
    if (is_first) found = {found.pairs, f, g, *place};
    return false;
  };
  test_neighbours(triangles, tree, begin, end, is_any, test);
  return found;
}

/// The faces of a tree, and which of all triangles these are.
struct ChosenFaces {
  const BoxTree& tree;
  const std::vector<int>& list;     ///< faces of the tree's primitives, ascending
  const std::vector<char>& chosen;  ///< a nonzero entry for each of them
  Aabb box;                         ///< box around all of them
};

using Pairs = std::vector<std::pair<int, int>>;

Pairs joined(const std::vector<Pairs>& parts) {
  Pairs pairs;
  for (const Pairs& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The pairs of triangles that cross, of which one is chosen.
Pairs find_pairs(const Triangles& triangles, const ChosenFaces& faces) {
  std::vector<Pairs> of_chunk(triangles.faces.size() / kChunk + 1);
  parallel_chunks(triangles.count(), kChunk, [&](int begin, int end) {
    for (int f = begin; f < end; ++f) {
      const TestedTriangle tested(triangles, f);
      if (!tested.box().overlaps(faces.box)) continue;
      faces.tree.visit_overlapping(tested.box(), [&](int i) {
        const int g = faces.list[at(i)];
        const bool comes_twice = faces.chosen[at(f)] != 0 && g <= f;
        if (!comes_twice && tested.crossing(g)) of_chunk[at(begin / kChunk)].push_back(std::minmax(f, g));
      });
    }
  });
  return joined(of_chunk);
}

}  // namespace

SelfIntersections find_self_intersections(const TriMesh& mesh) {
  return find_self_intersections(mesh, tree_of_faces(mesh, Bvh::Effort::few_queries));
}

SelfIntersections find_self_intersections(const TriMesh& mesh, const BoxTree& tree) {
  std::vector<SelfIntersections> of_chunk(at(tree.node_count() / kChunk + 1));
  const Triangles triangles{mesh.vertices(), mesh.faces()};
  parallel_chunks(tree.node_count(), kChunk, [&](int begin, int end) {
    of_chunk[at(begin / kChunk)] = find_in_range(triangles, tree, begin, end);
  });
  SelfIntersections found;
  for (const SelfIntersections& part : of_chunk) {
    const int pairs = found.pairs + part.pairs;
    const bool is_first = part.pairs > 0 && (found.pairs == 0 || std::pair(part.face_a, part.face_b) <
                                                                     std::pair(found.face_a, found.face_b));
    if (is_first) found = part;
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
  return find_pairs(triangles, {tree, list, chosen, all});
}

std::optional<std::vector<std::pair<int, int>>> find_crossing_pairs(const std::vector<dvec3>& points,
                                                                    const std::vector<ivec3>& faces,
                                                                    const BoxTree& tree, std::size_t most) {
  constexpr int kAtOnce = 8;  // chunks between looks at the number of pairs
  const Triangles triangles{points, faces};
  std::vector<Pairs> of_chunk(at(tree.node_count() / kChunk + 1));
  std::size_t count = 0;
  for (int first = 0; first < tree.node_count(); first += kAtOnce * kChunk) {
    parallel_chunks(std::min(kAtOnce * kChunk, tree.node_count() - first), kChunk, [&](int begin, int end) {
      Pairs& pairs = of_chunk[at((first + begin) / kChunk)];
      const auto test = [&](const TestedTriangle& tested, int g, const Aabb& box) {
        if (g > tested.face() && tested.crossing(g, box)) pairs.emplace_back(tested.face(), g);
        return false;
      };
      test_neighbours(triangles, tree, first + begin, first + end, is_any, test);
    });
    for (int c = 0; c < kAtOnce; ++c)
      if (const std::size_t chunk = at(first / kChunk + c); chunk < of_chunk.size()) count += of_chunk[chunk].size();
    if (count > most) return std::nullopt;
  }
  return joined(of_chunk);
}

std::vector<char> find_crossing_faces(const std::vector<dvec3>& points, const std::vector<ivec3>& faces,
                                      const BoxTree& tree, const std::vector<int>& shell_of_face,
                                      const std::function<bool(const std::vector<char>&)>& is_enough) {
  constexpr int kAtOnce = 16 * kChunk;  // nodes between questions whether it is enough
  const Triangles triangles{points, faces};
  std::vector<char> crosses(faces.size(), 0);
  // A face may be marked by the thread of the other one, before its own search or after.
  const auto mark = [&](int f) { return std::atomic_ref<char>(crosses[at(f)]); };
  const auto is_unknown = [&](int f) { return mark(f).load(std::memory_order_relaxed) == 0; };
  const auto test = [&](const TestedTriangle& tested, int g, const Aabb& box) {
    const int f = tested.face();
    if (shell_of_face[at(f)] != shell_of_face[at(g)] || !tested.crossing(g, box)) return false;
    mark(f).store(1, std::memory_order_relaxed);
    mark(g).store(1, std::memory_order_relaxed);
    return true;
  };
  for (int first = 0; first < tree.node_count(); first += kAtOnce) {
    parallel_chunks(std::min(kAtOnce, tree.node_count() - first), kChunk, [&](int begin, int end) {
      test_neighbours(triangles, tree, first + begin, first + end, is_unknown, test);
    });
    if (is_enough && is_enough(crosses)) break;
  }
  return crosses;
}

}  // namespace taxel
