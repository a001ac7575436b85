// The points and cells of a legacy VTK file, and the pressures at its points.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// A data set POLYDATA or UNSTRUCTURED_GRID. Polygons, strips, lines and vertices of POLYDATA are cells of the types
/// that they have in an unstructured grid (7, 6, 4, 2). All corners are indices of points, and all numbers are finite.
struct VtkData {
  std::vector<dvec3> points;
  std::vector<int> corners;         ///< corners of all cells
  std::vector<int> ends;            ///< for each cell the end of its corners
  std::vector<std::uint8_t> types;  ///< type of each cell, see vtk_cells.h
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
