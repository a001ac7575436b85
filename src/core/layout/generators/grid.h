// Rows and columns of taxels in a plane, or projected from a plane onto a skin.
#pragma once

#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A grid in a plane. Lengths in metres.
struct Grid {
  int rows = 1, columns = 1;
  double row_pitch = 0.005;     ///< distance between rows
  double column_pitch = 0.005;  ///< distance between columns
  dvec3 center{0};              ///< centre of the grid
  dvec3 along_row{1, 0, 0};     ///< direction between columns; any length
  dvec3 normal{0, 0, 1};        ///< outward normal of the plane; rows ascend along normal x along_row
  double radius = 0.005;        ///< radius of the receptive fields
};

/// Returns taxels at the grid's points, row by row (id = row * columns + column), with the plane's normal. along_row is
/// projected onto the plane. Throws Error that names the parameter.
std::vector<Taxel> planar_grid(const Grid& grid);

/// Returns taxels at the first intersections of rays along `direction` (any length) from the grid's points with the
/// skin, with the smooth normals there. The pitch in the view along `direction` is that of the grid; on a slope taxels
/// are farther apart. Throws Error that names the parameter, or the row and column whose ray misses the skin or begins
/// inside it.
std::vector<Taxel> curved_grid(const Grid& grid, const dvec3& direction, const MeshIndex& skin,
                               Beyond beyond = Beyond::refuse);

}  // namespace taxel
