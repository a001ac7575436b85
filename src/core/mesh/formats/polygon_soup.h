// A triangle soup: the triangles of a mesh file in the order of the file, before any repair.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// The vertices as listed in the file and the triangles over them. A polygon of more than three corners is cut into
/// triangles. All indices are in range and all coordinates are finite: the readers throw Error otherwise.
struct PolygonSoup {
  std::vector<dvec3> vertices;
  std::vector<ivec3> triangles;
  int fanned = 0;                  ///< number of polygons with more than three corners
  int skipped = 0;                 ///< number of polygons with fewer than three corners
  std::vector<std::string> notes;  ///< other changes of the reader, such as "took the boundary of 12 tets"

  /// Adds the triangles of a polygon. `corners` are indices of vertices, in the polygon's order.
  void add_polygon(std::span<const int> corners) {
    if (corners.size() < 3) ++skipped;
    if (corners.size() > 3) ++fanned;
    constexpr std::size_t kMaxFan = 64;
    if (corners.size() > kMaxFan) return halve_polygon(corners);
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
  }

  /// Cuts a polygon of many corners into halves recursively. The triangles of a fan share a corner, so the boxes of all
  /// of them would overlap, and a search for intersecting triangles would take quadratic time.
  void halve_polygon(std::span<const int> corners) {
    if (corners.size() < 3) return;
    const std::size_t middle = corners.size() / 2;
    halve_polygon(corners.subspan(0, middle + 1));
    triangles.emplace_back(corners.front(), corners[middle], corners.back());
    halve_polygon(corners.subspan(middle));
  }
};

}  // namespace taxel
