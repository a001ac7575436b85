// The types of VTK cells, and the faces of those that enclose a volume.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace taxel {

/// A type of cell. Curved cells (quadratic, Lagrange, Bezier) are taken as the straight cell of their corners, which
/// are the first of their points.
struct VtkCellType {
  int type;               ///< number in the file
  std::string_view name;  ///< such as "quadratic tet"
  int straight;           ///< number of the straight type: 3 for all that have no area, or 5 to 14
  int points;             ///< number of points; 0 for any number
  [[nodiscard]] bool curved() const { return straight != type && straight >= 5; }
};

/// Returns the row of a type; null if cells of the type are not read.
const VtkCellType* find_vtk_cell_type(int type);

/// Returns the number of corners of a straight cell (0 for strips and polygons, which may have any number).
int vtk_corner_count(int straight);

/// One face of a cell: up to four positions in the list of the cell's corners, filled up with -1.
using VtkFace = std::array<int, 4>;

/// Returns the faces of a straight cell (10 to 14), empty for all others. They all point outward, or all inward: files
/// have cells of both orders, most of all wedges.
std::span<const VtkFace> vtk_faces(int straight);

}  // namespace taxel
