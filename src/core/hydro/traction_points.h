// A contact surface reduced to few points, for laws that are evaluated many times on the same surface.
#pragma once

#include <vector>

#include "core/hydro/traction.h"

namespace taxel {

/// Each polygon's pressure force at its centre of pressure; of a polygon that is a large part of the surface, at the
/// points of a quadrature rule. The elastic wrench is that of the surface, and so are friction and damping of a surface
/// that moves without turning; of one that turns, they differ from traction() of the surface by the second order of the
/// polygons' size. On surfaces of many polygons an evaluation costs about a thirtieth of traction()'s.
class TractionPoints {
 public:
  /// Keeps the memory of the last surface.
  void assign(const ContactSurface& surface);

  /// As traction(surface, pair, V_BA).
  [[nodiscard]] Traction evaluate(const PairProperties& pair, const Twist& V_BA) const;

 private:
  struct Point {
    dvec3 x{0};       // centre of pressure
    dvec3 normal{0};  // of the polygon
    double push = 0;  // integral of p0 dA [N]
  };
  void add_quadrature(const ContactSurface& surface, const ContactPolygon& polygon);

  std::vector<Point> points_;
};

}  // namespace taxel
