#include "core/mesh/edge_sides.h"

#include <tuple>

namespace taxel {

std::vector<EdgeSide> edge_sides(const TriMesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * mesh.faces().size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& ids = mesh.faces()[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c) {
      const int a = ids[c], b = ids[(c + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), f, c, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  return sides;
}

}  // namespace taxel
