// Triangles of the polygons in mesh files.
#pragma once

#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Adds triangles that cover a polygon, whose `corners` are indices of vertices in its order. A convex polygon becomes
/// a fan, and above 64 corners halves of halves: the triangles of a fan share a corner, so the boxes of all of them
/// would overlap, and a search for intersecting triangles would take quadratic time. Polygons with corners of 180
/// degrees or more are cut ear by ear (Meisters 1975), without triangles of no area, up to 4000 corners. Polygons
/// without area, with a vertex that is not listed yet, or that cut through themselves, become fans too.
void add_polygon_triangles(std::span<const dvec3> vertices, std::span<const int> corners,
                           std::vector<ivec3>& triangles);

}  // namespace taxel
