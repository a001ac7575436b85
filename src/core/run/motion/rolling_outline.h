// A body that rolls on a plane without slipping.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The outline of a body in the view along y: the convex hull of its vertices in x and z. While the body turns about y
/// by an angle (positive: towards +x) on a plane below it, a vertex of the outline rests on the plane until the next
/// edge is in the plane. The contact travels the length of the outline that has rolled off: R times the angle for a
/// circle.
class RollingOutline {
 public:
  /// `q_WM` is the orientation of the body at angle 0. Requires at least one vertex.
  RollingOutline(const TriMesh& body, const dquat& q_WM);
  struct Contact {
    dvec2 vertex{0};       ///< x and z, at angle 0, of the vertex that rests on the plane [m]
    double travelled = 0;  ///< travel of the contact along x since angle 0 [m]
  };
  /// Returns the contact at an angle [rad].
  [[nodiscard]] Contact at(double angle) const;

 private:
  std::vector<dvec2> hull_;  ///< counter-clockwise from x to z, from the lowest vertex
};

}  // namespace taxel
