// Rows x columns of taxels: on a plane, or a planar grid projected onto a skin.
#pragma once

#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A grid in a plane. Lengths in metres.
struct Grid {
  int rows = 1, columns = 1;
  double row_pitch = 0.005;     ///< from row to row
  double column_pitch = 0.005;  ///< from column to column
  dvec3 center{0};              ///< of the whole grid
  dvec3 along_row{1, 0, 0};     ///< from column to column; any length
  dvec3 normal{0, 0, 1};        ///< of the plane, outward; rows follow one another along normal x along_row
  double radius = 0.005;        ///< of the receptive fields
};

/// Taxels at the grid's points, row by row (id = row * columns + column), all with the plane's normal. along_row is
/// turned into the plane. Throws Error naming the parameter.
std::vector<Taxel> planar_grid(const Grid& grid);

/// The grid's points projected along `direction` (any length) onto the skin: where the ray first meets it, with the
/// smooth normals there. Straight projection keeps the pitch seen along `direction`; on a slope taxels lie further
/// apart. Throws Error naming the parameter, or the row and column whose ray misses the skin or begins inside it.
std::vector<Taxel> curved_grid(const Grid& grid, const dvec3& direction, const MeshIndex& skin,
                               Beyond beyond = Beyond::refuse);

}  // namespace taxel
