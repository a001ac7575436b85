#include "core/mesh/topology/edge_topology.h"

#include <algorithm>
#include <cstdint>

#include "core/base/index.h"

namespace taxel {

/// Half-edges are first sorted by their lower vertex, by counting. The few at one vertex are then sorted by the higher
/// vertex and the half-edge, which one 64-bit key holds with a last bit that is 1 if the half-edge is forward.
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

}  // namespace taxel
