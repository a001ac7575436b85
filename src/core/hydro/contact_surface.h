// The surface two bodies share: planar polygons with a linear pressure on each.
#pragma once

#include <string>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Polygon i owns vertices [first, first + count), counter-clockwise about `normal`.
struct ContactPolygon {
  int first = 0, count = 0;
  dvec3 normal{0};      ///< unit; the direction in which the surface pushes body A
  double area = 0;      ///< [m^2]
  dvec3 centroid{0};    ///< of the area
  double pressure = 0;  ///< elastic pressure p0 at the centroid [Pa]
  dvec3 gradient{0};    ///< of p0 [Pa/m]; p0(x) = pressure + dot(gradient, x - centroid)
  int tet = -1;         ///< of the soft body; -1 in a half-space
  int face = -1;        ///< of the rigid mesh; -1 on a half-space
};

/// What was not taken into the surface, and why.
struct RejectedPolygons {
  std::string reason;  ///< stable word: "sliver", ...
  int count = 0;
  double area = 0;  ///< [m^2]
};

/// Everything in the frame of body A. Reused from step to step: clear() keeps the memory.
struct ContactSurface {
  std::vector<dvec3> vertices;
  std::vector<double> pressure;  ///< p0 at each vertex, never negative [Pa]
  std::vector<ContactPolygon> polygons;
  std::vector<RejectedPolygons> rejected;
  int at_core = 0;  ///< polygons that end on a pad's rigid core: the overlap is deeper there than the field reaches

  void clear();
  [[nodiscard]] bool empty() const { return polygons.empty(); }
  [[nodiscard]] double area() const;
  [[nodiscard]] double max_pressure() const;
  [[nodiscard]] int triangle_count() const;  ///< sum of (count - 2)
};

}  // namespace taxel
