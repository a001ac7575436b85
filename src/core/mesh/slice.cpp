#include "core/mesh/slice.h"

#include "core/base/index.h"

namespace taxel {
std::vector<std::pair<dvec3, dvec3>> slice_mesh(const TriMesh& mesh, const dvec3& point, const dvec3& normal) {
  std::vector<double> height;
  height.reserve(mesh.vertices().size());
  for (const dvec3& v : mesh.vertices()) height.push_back(glm::dot(v - point, normal));
  const auto above = [&](int v) { return height[at(v)] >= 0; };
  // The point of edge a b on the plane, computed from the lower vertex: both faces of the edge get equal bits.
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
