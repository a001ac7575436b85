#include "core/hydro/triangle_probe.h"

namespace taxel {

TriangleProbe::TriangleProbe(const Triangle& triangle, const dvec3& unit_normal, double slack) : slack_(slack) {
  for (const dvec3& v : triangle) box_.include(v);
  box_.lo -= slack;
  box_.hi += slack;
  plane_ = {unit_normal, glm::abs(unit_normal), -glm::dot(unit_normal, triangle[0])};
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3& a = triangle[i];
    const dvec3 outward = glm::normalize(glm::cross(triangle[(i + 1) % 3] - a, unit_normal));
    edges_[i] = {outward, glm::abs(outward), -glm::dot(outward, a) - slack};
  }
}

}  // namespace taxel
