// The share of a surface that is within a skin, by area.
//
// Each triangle is divided evenly into smaller ones of at most a twentieth of the surface's diagonal, and the middle of
// each is tested by its signed distance to the skin, with a margin of the pad's thickness or a fiftieth of the skin.
// Cost: one distance per part.
#include "core/sensor/skin_cover.h"

#include <algorithm>
#include <cmath>

namespace taxel {

double share_within_skin(const TriMesh& surface, const RigidTransform& X_skin, const MeshIndex& skin,
                         double thickness) {
  constexpr double kMargin = 0.02;  // of the skin's diagonal
  const double reach = std::max(thickness, kMargin * skin.mesh().bounds().diagonal());
  const double part = 0.05 * surface.bounds().diagonal();  // largest edge of a part [m]
  double within = 0, all = 0;
  for (int f = 0; f < surface.face_count(); ++f) {
    const dvec3 a = surface.vertex(f, 0), u = surface.vertex(f, 1) - a, v = surface.vertex(f, 2) - a;
    const double longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
    const int n = std::max(1, static_cast<int>(std::ceil(longest / part)));
    int inside = 0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // upward triangles at even j, downward ones at odd j
        const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
        const dvec3 middle = a + (i + third) / n * u + (j / 2 + third) / n * v;
        inside += skin.signed_distance(X_skin(middle)) <= reach ? 1 : 0;
      }
    }
    const double area = 0.5 * glm::length(glm::cross(u, v));
    within += area * inside / (static_cast<double>(n) * n);
    all += area;
  }
  return all > 0 ? within / all : 0;
}

}  // namespace taxel
