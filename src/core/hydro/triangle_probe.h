// A quick, conservative test of one triangle against many boxes.
#pragma once

#include "core/hydro/clip.h"

namespace taxel {

/// Separating axes: the box's three, the triangle's normal, and the three normals of its edges in its plane. A box that
/// is refused does not meet the triangle; some that do not are let through (the nine axes of crossed edges are left
/// out: the exact clip that follows is cheaper than they are).
class TriangleProbe {
 public:
  /// `slack` widens the triangle [m].
  TriangleProbe(const Triangle& triangle, const dvec3& unit_normal, double slack);

  [[nodiscard]] bool may_meet(const Aabb& box) const {
    if (!box_.overlaps(box)) return false;
    const dvec3 center = box.center(), half = 0.5 * box.extent();
    if (std::abs(glm::dot(plane_.normal, center) + plane_.offset) > glm::dot(plane_.size, half) + slack_) return false;
    for (const Plane& edge : edges_) {
      if (glm::dot(edge.normal, center) + edge.offset > glm::dot(edge.size, half)) return false;
    }
    return true;
  }

 private:
  struct Plane {
    dvec3 normal{0}, size{0};  ///< size: absolute components of the normal
    double offset = 0;
  };
  Aabb box_;
  Plane plane_;
  std::array<Plane, 3> edges_;
  double slack_;
};

}  // namespace taxel
