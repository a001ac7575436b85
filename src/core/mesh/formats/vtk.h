// Legacy VTK files: the types of cells with the faces of those that enclose a volume, and the points, cells and
// pressures of a file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

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

/// A data set POLYDATA or UNSTRUCTURED_GRID. Polygons, strips, lines and vertices of POLYDATA are cells of the types
/// that they have in an unstructured grid (7, 6, 4, 2). All corners are indices of points, and all numbers are finite.
struct VtkData {
  std::vector<dvec3> points;
  std::vector<int> corners;         ///< corners of all cells
  std::vector<int> ends;            ///< for each cell the end of its corners
  std::vector<std::uint8_t> types;  ///< type of each cell, see vtk.h
  std::vector<double> pressure;     ///< one per point; empty if the file has none or they were not asked for
  bool poly_data = false;

  [[nodiscard]] std::span<const int> cell(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : static_cast<std::size_t>(ends[i - 1]);
    return {corners.data() + begin, static_cast<std::size_t>(ends[i]) - begin};
  }
};

enum class VtkAttributes { skip, pressure };

/// Reads a legacy VTK file of version 1 to 5.1, ASCII or BINARY. With VtkAttributes::pressure it also looks for point
/// data of one component named `pressure` (SCALARS or FIELD); other attributes are passed over. Throws Error naming the
/// file and the line (ASCII) or byte (BINARY) if the file has another data set, is damaged, or announces more than its
/// size can hold.
VtkData read_vtk_data(std::string_view bytes, const std::string& file, VtkAttributes attributes);

}  // namespace taxel
