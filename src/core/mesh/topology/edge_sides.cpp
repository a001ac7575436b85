#include "core/mesh/topology/edge_sides.h"

#include <tuple>

namespace taxel {

std::vector<EdgeSide> edge_sides(std::size_t vertex_count, std::span<const ivec3> faces) {
  const auto low_of = [](const ivec3& ids, int c) { return std::min(ids[c], ids[(c + 1) % 3]); };
  // Counting sort by the low vertex: next[v] is where the next side with that vertex goes.
  std::vector<std::size_t> next(vertex_count + 1, 0);
  for (const ivec3& ids : faces)
    for (int c = 0; c < 3; ++c) ++next[static_cast<std::size_t>(low_of(ids, c)) + 1];
  for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
  std::vector<EdgeSide> sides(3 * faces.size());
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    const ivec3& ids = faces[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c) {
      const int a = ids[c], b = ids[(c + 1) % 3];
      sides[next[static_cast<std::size_t>(low_of(ids, c))]++] = {std::min(a, b), std::max(a, b), f, c, a < b};
    }
  }
  // next[v] has become the end of v's sides.
  for (std::size_t v = 0, begin = 0; v < vertex_count; begin = next[v++]) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin), sides.begin() + static_cast<std::ptrdiff_t>(next[v]),
              [](const EdgeSide& a, const EdgeSide& b) { return std::tie(a.high, a.face) < std::tie(b.high, b.face); });
  }
  return sides;
}

}  // namespace taxel
