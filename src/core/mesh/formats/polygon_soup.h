// A triangle soup: the triangles of a mesh file in the order of the file, before any repair.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/formats/polygon_triangles.h"

namespace taxel {

/// The vertices as listed in the file and the triangles over them. A polygon of more than three corners is cut into
/// triangles. All indices are in range and all coordinates are finite: the readers throw Error otherwise.
struct PolygonSoup {
  std::vector<dvec3> vertices;
  std::vector<ivec3> triangles;
  int fanned = 0;                  ///< number of polygons with more than three corners
  int skipped = 0;                 ///< number of polygons with fewer than three corners
  std::vector<std::string> notes;  ///< other changes of the reader, such as "took the boundary of 12 tets"

  /// Adds the triangles of a polygon. `corners` are indices of vertices, which should be listed already, in the
  /// polygon's order.
  void add_polygon(std::span<const int> corners) {
    if (corners.size() < 3) ++skipped;
    if (corners.size() > 3) ++fanned;
    add_polygon_triangles(vertices, corners, triangles);
  }
};

}  // namespace taxel
