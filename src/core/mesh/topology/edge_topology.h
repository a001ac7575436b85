// The half-edges of a triangle mesh: twins, edges, fans of faces around vertices, boundary loops, faulty edges.
//
//        c          A face (a, b, c) has the half-edges a -> b, b -> c and c -> a, counter-clockwise. The half-edge
//       / \         3 face + corner begins at that corner. Its twin is the same edge in the face across, where it
//      /   \        runs the other way. The half-edges that begin at one vertex form fans: each is a row or a ring
//     a --> b       of faces, every one joined to the next by twins.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// The half-edge after h around its face.
inline int next_edge(int h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
/// The half-edge before h around its face.
inline int previous_edge(int h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// The faces at an edge: only an inner edge joins its faces.
enum class EdgeKind {
  inner,        ///< two faces that pass the edge in opposite directions
  boundary,     ///< one face
  misoriented,  ///< two faces that pass the edge in the same direction
  nonmanifold   ///< more than two faces
};

/// Fans of faces around vertices, numbered by their lowest half-edge.
struct VertexFans {
  std::vector<int> fan_of;   ///< fan at the vertex where each half-edge begins
  std::vector<int> corners;  ///< half-edges that begin at the vertex, counter-clockwise, fan after fan
  std::vector<int> first;    ///< index in `corners` of each fan's first half-edge, and the end of the last fan

  [[nodiscard]] int count() const { return static_cast<int>(first.size()) - 1; }
  [[nodiscard]] std::span<const int> corners_of(int fan) const {
    const auto f = static_cast<std::size_t>(fan);
    return std::span(corners).subspan(static_cast<std::size_t>(first[f]),
                                      static_cast<std::size_t>(first[f + 1] - first[f]));
  }
};

/// Connectivity of any triangles, manifold or not. At a boundary, misoriented or nonmanifold edge the surface ends: its
/// half-edges have no twin. Immutable; O(n log n) for n faces, in practice linear.
class EdgeTopology {
 public:
  EdgeTopology() = default;
  /// Each face has three different vertices below `vertex_count`.
  EdgeTopology(std::vector<ivec3> faces, std::size_t vertex_count);

  [[nodiscard]] const std::vector<ivec3>& faces() const { return faces_; }
  [[nodiscard]] int half_edge_count() const { return static_cast<int>(twins_.size()); }
  /// The vertex where a half-edge begins.
  [[nodiscard]] int from(int h) const { return faces_[static_cast<std::size_t>(h / 3)][h % 3]; }
  /// The vertex where a half-edge ends.
  [[nodiscard]] int to(int h) const { return from(next_edge(h)); }
  /// The lower of the two vertices of a half-edge.
  [[nodiscard]] int low(int h) const { return std::min(from(h), to(h)); }
  /// The higher of the two vertices of a half-edge.
  [[nodiscard]] int high(int h) const { return std::max(from(h), to(h)); }
  /// Returns true if a half-edge runs from its lower vertex to its higher one.
  [[nodiscard]] bool is_forward(int h) const { return from(h) < to(h); }
  /// The twin of a half-edge, or -1 if the surface ends there.
  [[nodiscard]] int twin(int h) const { return twins_[static_cast<std::size_t>(h)]; }
  /// The face across a half-edge, or -1 if the surface ends there.
  [[nodiscard]] int face_across(int h) const { return twin(h) < 0 ? -1 : twin(h) / 3; }
  /// Returns true if there are faces and each half-edge has a twin.
  [[nodiscard]] bool is_closed() const { return closed_; }

  [[nodiscard]] int edge_count() const { return static_cast<int>(first_.size()) - 1; }
  /// All half-edges of an edge in the order of their faces. Edges are in the order of (low, high).
  [[nodiscard]] std::span<const int> edge(int e) const {
    const int *begin = half_edges_.data() + first_[static_cast<std::size_t>(e)],
              *end = half_edges_.data() + first_[static_cast<std::size_t>(e) + 1];
    return {begin, end};
  }
  /// Calls body(half-edges of one edge) for every edge in order.
  template <class Body>
  void for_each_edge(const Body& body) const {
    for (int e = 0; e < edge_count(); ++e) body(edge(e));
  }
  /// The half-edges of the edge between two vertices, or none if there is no such edge. O(log n).
  [[nodiscard]] std::span<const int> edge_between(int a, int b) const;
  /// The kind of an edge, given its half-edges.
  [[nodiscard]] EdgeKind kind(std::span<const int> edge) const;
  /// The edges of one kind in order, each as its half-edges.
  [[nodiscard]] std::vector<std::span<const int>> edges_of(EdgeKind kind) const;

  /// Walks around every vertex. O(n).
  [[nodiscard]] VertexFans vertex_fans() const;
  /// Vertices with more than one fan, ascending. O(n).
  [[nodiscard]] std::vector<int> nonmanifold_vertices() const;
  /// The half-edges without a twin as closed loops, each continued at its end by the next one around the same fan, in
  /// the order of their lowest half-edges. Holes lie to the right. O(n).
  [[nodiscard]] std::vector<std::vector<int>> boundary_loops() const;

 private:
  std::vector<ivec3> faces_;
  std::vector<int> half_edges_;  ///< by edge
  std::vector<int> first_{0};    ///< for each edge, its first index in half_edges_; then the total number
  std::vector<int> twins_;
  bool closed_ = false;
};

}  // namespace taxel
