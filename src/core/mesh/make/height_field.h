// A height field as a closed mesh, as MuJoCo defines it.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// MuJoCo's `hfield`: a grid of points over [-x, x] x [-y, y], columns along x, rows along y.
struct HeightField {
  int rows = 0, columns = 0;      ///< at least 2 each
  std::vector<double> elevation;  ///< row after row, in units of size.z above z = 0
  dvec3 size{0};                  ///< half extents in x and y, height of elevation 1 in z [m]
  double base = 0;                ///< depth of the body below z = 0 [m]
};

/// Returns the surface that MuJoCo collides with: two triangles per cell, cut along the diagonal from the lower row and
/// column to the higher ones, closed by vertical sides and a flat base. Throws Error if there are too few rows or
/// columns or a wrong number of elevations, if an elevation is not finite or not above the base, or if a size or the
/// base is not positive.
TriMesh make_height_field(const HeightField& field);

}  // namespace taxel
