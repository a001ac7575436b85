#include "core/sensor/rays/tet_crossings.h"

#include <algorithm>

namespace taxel {

TetCrossings::TetCrossings(const PressureField& field) : field_(field), tree_(tree_of_tets(field)) {
  const Aabb& box = field.bounds();
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  coordinates_ = largest.x + largest.y + largest.z;
  for (const Tet& tet : field.tets()) widest_ = std::max(widest_, width(tet));
}

void TetCrossings::find(const SensorRay& ray, std::vector<std::int32_t>& found) const {
  const SlabTest slabs(Ray{ray.origin, ray.direction});
  found.clear();
  tree_.visit(
      [&](const Aabb& box) {
        return slabs.entry({box.lo - widest_, box.hi + widest_}, ray.max_depth) < SlabTest::kMiss;
      },
      [&](int tet) {
        if (crosses(tet, ray)) found.push_back(tet);
      });
  std::sort(found.begin(), found.end());
}

/// Returns the largest distance outside of a tet of a hit on one of its polygons. Merged vertices move by less than
/// 1e-6 of the tet's size, and rim_reach() of its polygons is less than 1e-8 of the coordinates.
double TetCrossings::width(const Tet& tet) const {
  return 2e-6 * tet.size + 1e-8 * coordinates_;
}

/// Clips the ray by the four planes.
bool TetCrossings::crosses(int number, const SensorRay& ray) const {
  const Tet& tet = field_.tets()[static_cast<std::size_t>(number)];
  double t_min = 0, t_max = ray.max_depth;
  for (std::size_t i = 0; i < 4; ++i) {
    const double rate = glm::dot(tet.normal[i], ray.direction);
    const double start = glm::dot(tet.normal[i], ray.origin) + tet.offset[i] + width(tet);
    if (rate > 0) t_min = std::max(t_min, -start / rate);
    if (rate < 0) t_max = std::min(t_max, -start / rate);
    if (rate == 0 && start < 0) return false;
  }
  return t_min <= t_max;
}

}  // namespace taxel
