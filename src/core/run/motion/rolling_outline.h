// A body that rolls on a plane without slipping.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The outline of a body as it is seen along y: the convex hull of its vertices in x and z. Where the body turns about
/// y by an angle (positive: towards +x) and touches a plane below it all the while, a vertex of the outline rests on
/// the plane until the next edge lies in it: the way of the contact is the length of outline that was rolled off,
/// R times the angle of a circle.
class RollingOutline {
 public:
  /// `R_WM`: how the body is turned at angle 0. At least one vertex.
  RollingOutline(const TriMesh& body, const dquat& q_WM);
  struct Contact {
    dvec2 vertex{0};       ///< x and z of the one that rests on the plane, with the body as it is at angle 0 [m]
    double travelled = 0;  ///< by the contact along x since angle 0 [m]
  };
  [[nodiscard]] Contact at(double angle) const;

 private:
  std::vector<dvec2> hull_;  ///< counter-clockwise from x to z, beginning at the lowest
};

}  // namespace taxel
