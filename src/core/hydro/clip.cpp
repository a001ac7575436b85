#include "core/hydro/clip.h"

namespace taxel {
namespace {

/// A polygon in barycentric coordinates of its triangle.
struct WeightPolygon {
  std::array<dvec3, ClippedPolygon::kCapacity> weights;
  std::size_t count = 0;
};

/// Keeps what has dot(distances, weights) >= 0 (Sutherland, Hodgman 1974).
void keep_inside(const dvec3& distances, const WeightPolygon& in, WeightPolygon& out) {
  out.count = 0;
  dvec3 a = in.weights[in.count - 1];
  double da = glm::dot(distances, a);
  for (std::size_t i = 0; i < in.count; ++i) {
    const dvec3& b = in.weights[i];
    const double db = glm::dot(distances, b);
    if ((da < 0) != (db < 0) && da != 0 && db != 0) out.weights[out.count++] = a + (da / (da - db)) * (b - a);
    if (!(db < 0)) out.weights[out.count++] = b;
    a = b;
    da = db;
  }
}

void to_points(const Triangle& triangle, const WeightPolygon& polygon, ClippedPolygon& out) {
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const dvec3& w = polygon.weights[i];
    out.points[i] = w.x * triangle[0] + w.y * triangle[1] + w.z * triangle[2];  // exact at the corners
  }
  out.count = polygon.count;
}

WeightPolygon whole_triangle() {
  WeightPolygon polygon;
  polygon.weights[0] = {1, 0, 0};
  polygon.weights[1] = {0, 1, 0};
  polygon.weights[2] = {0, 0, 1};
  polygon.count = 3;
  return polygon;
}

}  // namespace

void clip_triangle(const Triangle& triangle, const Tet& tet, int index, ClippedPolygon& out) {
  out.count = 0;
  out.cut_by = 0;
  std::array<dvec3, 4> distances;
  for (std::size_t i = 0; i < 4; ++i) {
    dvec3& d = distances[i];
    for (int k = 0; k < 3; ++k) d[k] = glm::dot(tet.normal[i], triangle[static_cast<std::size_t>(k)]) + tet.offset[i];
    if (d.x < 0 || d.y < 0 || d.z < 0) {
      if (d.x <= 0 && d.y <= 0 && d.z <= 0) return;  // outside; at most an edge of it touches
      out.cut_by |= 1u << i;
    } else if (d.x == 0 && d.y == 0 && d.z == 0) {
      const int neighbour = tet.neighbour[static_cast<int>(i)];
      if (neighbour >= 0 && neighbour < index) return;
    }
  }
  if (out.cut_by == 0) {
    std::copy(triangle.begin(), triangle.end(), out.points.begin());
    out.count = 3;
    return;
  }
  WeightPolygon polygon = whole_triangle(), other;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((out.cut_by & (1u << i)) == 0) continue;
    keep_inside(distances[i], polygon, other);
    std::swap(polygon.weights, other.weights);
    polygon.count = other.count;
    if (polygon.count < 3) return;
  }
  to_points(triangle, polygon, out);
}

void slice_tet(const std::array<dvec3, 4>& corners, const ivec4& vertices, const std::array<double, 4>& distances,
               ClippedPolygon& out) {
  // Edges in the order in which they go around, for each set of corners on the positive side (bit i: corner i), of a
  // positively oriented tet.
  using Edge = std::array<std::size_t, 2>;
  struct Ring {
    std::size_t count;
    std::array<Edge, 4> edges;
  };
  static constexpr std::array<Ring, 16> kRings{{
      {0, {}},
      {3, {{{0, 1}, {0, 3}, {0, 2}}}},
      {3, {{{1, 0}, {1, 2}, {1, 3}}}},
      {4, {{{0, 2}, {1, 2}, {1, 3}, {0, 3}}}},
      {3, {{{2, 0}, {2, 3}, {2, 1}}}},
      {4, {{{2, 1}, {0, 1}, {0, 3}, {2, 3}}}},
      {4, {{{1, 0}, {2, 0}, {2, 3}, {1, 3}}}},
      {3, {{{3, 0}, {3, 2}, {3, 1}}}},
      {3, {{{3, 0}, {3, 1}, {3, 2}}}},
      {4, {{{1, 3}, {2, 3}, {2, 0}, {1, 0}}}},
      {4, {{{2, 3}, {0, 3}, {0, 1}, {2, 1}}}},
      {3, {{{2, 0}, {2, 1}, {2, 3}}}},
      {4, {{{0, 3}, {1, 3}, {1, 2}, {0, 2}}}},
      {3, {{{1, 0}, {1, 3}, {1, 2}}}},
      {3, {{{0, 1}, {0, 2}, {0, 3}}}},
      {0, {}},
  }};
  unsigned positive = 0;
  for (unsigned i = 0; i < 4; ++i) positive |= (distances[i] < 0 ? 0u : 1u) << i;
  const Ring& ring = kRings[positive];
  for (std::size_t e = 0; e < ring.count; ++e) {
    auto [a, b] = ring.edges[e];
    if (vertices[static_cast<int>(a)] > vertices[static_cast<int>(b)]) std::swap(a, b);
    out.points[e] = corners[a] + distances[a] / (distances[a] - distances[b]) * (corners[b] - corners[a]);
  }
  out.count = ring.count;
  out.cut_by = 0;
  for (unsigned i = 0; i < 4; ++i) {  // face i holds the other three corners
    const unsigned face = 0xFu & ~(1u << i);
    if ((positive & face) != 0 && (positive & face) != face) out.cut_by |= 1u << i;
  }
}

void clip_triangle_by_plane(const Triangle& triangle, const dvec3& distances, ClippedPolygon& out) {
  out.count = 0;
  out.cut_by = 0;
  if (!(distances.x < 0 || distances.y < 0 || distances.z < 0)) return;
  if (distances.x <= 0 && distances.y <= 0 && distances.z <= 0) {
    std::copy(triangle.begin(), triangle.end(), out.points.begin());
    out.count = 3;
    return;
  }
  WeightPolygon polygon;
  keep_inside(-distances, whole_triangle(), polygon);
  to_points(triangle, polygon, out);
}

}  // namespace taxel
