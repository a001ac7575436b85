// A height field as a closed mesh, the way MuJoCo defines it.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// MuJoCo's `hfield`: a grid of points over [-x, x] x [-y, y], columns along x, rows along y.
struct HeightField {
  int rows = 0, columns = 0;      ///< at least 2 each
  std::vector<double> elevation;  ///< row after row; times size z this is the height above z = 0
  dvec3 size{0};                  ///< x and y: half extents; z: height of elevation 1 [m]
  double base = 0;                ///< the body reaches down to z = -base [m]
};

/// The surface that MuJoCo collides with: two triangles per cell, cut along the diagonal from the lower row and column
/// to the higher ones, closed by vertical sides and a flat base. Throws Error: too few rows or columns, a wrong number
/// of elevations, one not finite or as low as the base, a size or the base not positive.
TriMesh make_height_field(const HeightField& field);

}  // namespace taxel
