// A triangle soup: the triangles of a mesh file in the order of the file, before any repair, cut from its polygons.
// weld() makes a valid TriMesh of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Adds triangles that cover a polygon, whose `corners` are indices of vertices in its order. A convex polygon becomes
/// a fan, and above 64 corners halves of halves: the triangles of a fan share a corner, so the boxes of all of them
/// would overlap, and a search for intersecting triangles would take quadratic time. Polygons with corners of 180
/// degrees or more are cut ear by ear (Meisters 1975), without triangles of no area, up to 4000 corners. Polygons
/// without area, with a vertex that is not listed yet, or that cut through themselves, become fans too.
void add_polygon_triangles(std::span<const dvec3> vertices, std::span<const int> corners,
                           std::vector<ivec3>& triangles);

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

/// Makes a valid mesh: scales, welds vertices at exactly the same place, drops triangles without area (two corners at
/// one place, or an area lost in the rounding of its edges) and repeated ones (same corners, same direction), drops
/// unused vertices. Keeps the order of the rest. Describes the changes in `notes`. A negative product of the scale
/// flips the winding. `face_of` (optional) gets the number in `soup` of each face's triangle. Throws Error without a
/// file name if the scale is not finite or zero, an index is out of range, or there are no triangles.
TriMesh weld(PolygonSoup soup, const dvec3& scale, std::vector<std::string>& notes,
             std::vector<int>* face_of = nullptr);

}  // namespace taxel
