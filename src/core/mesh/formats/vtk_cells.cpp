#include "core/mesh/formats/vtk_cells.h"

#include <algorithm>

namespace taxel {
namespace {

constexpr std::array<VtkCellType, 45> kTypes{{{0, "empty cell", 3, 0},
                                              {1, "vertex", 3, 1},
                                              {2, "list of vertices", 3, 0},
                                              {3, "line", 3, 2},
                                              {4, "polyline", 3, 0},
                                              {5, "triangle", 5, 3},
                                              {6, "triangle strip", 6, 0},
                                              {7, "polygon", 7, 0},
                                              {8, "pixel", 8, 4},
                                              {9, "quad", 9, 4},
                                              {10, "tet", 10, 4},
                                              {11, "voxel", 11, 8},
                                              {12, "hexahedron", 12, 8},
                                              {13, "wedge", 13, 6},
                                              {14, "pyramid", 14, 5},
                                              {21, "quadratic edge", 3, 3},
                                              {22, "quadratic triangle", 5, 6},
                                              {23, "quadratic quad", 9, 8},
                                              {24, "quadratic tet", 10, 10},
                                              {25, "quadratic hexahedron", 12, 20},
                                              {26, "quadratic wedge", 13, 15},
                                              {27, "quadratic pyramid", 14, 13},
                                              {28, "biquadratic quad", 9, 9},
                                              {29, "triquadratic hexahedron", 12, 27},
                                              {30, "quadratic linear quad", 9, 6},
                                              {31, "quadratic linear wedge", 13, 12},
                                              {32, "biquadratic quadratic wedge", 13, 18},
                                              {33, "biquadratic quadratic hexahedron", 12, 24},
                                              {34, "biquadratic triangle", 5, 7},
                                              {35, "cubic line", 3, 4},
                                              {37, "triquadratic pyramid", 14, 19},
                                              {68, "Lagrange curve", 3, 0},
                                              {69, "Lagrange triangle", 5, 0},
                                              {70, "Lagrange quad", 9, 0},
                                              {71, "Lagrange tet", 10, 0},
                                              {72, "Lagrange hexahedron", 12, 0},
                                              {73, "Lagrange wedge", 13, 0},
                                              {74, "Lagrange pyramid", 14, 0},
                                              {75, "Bezier curve", 3, 0},
                                              {76, "Bezier triangle", 5, 0},
                                              {77, "Bezier quad", 9, 0},
                                              {78, "Bezier tet", 10, 0},
                                              {79, "Bezier hexahedron", 12, 0},
                                              {80, "Bezier wedge", 13, 0},
                                              {81, "Bezier pyramid", 14, 0}}};

constexpr std::array<VtkFace, 4> kTet{{{0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {0, 2, 1, -1}}};
constexpr std::array<VtkFace, 6> kHexahedron{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
/// A voxel is a hexahedron whose corners are in the order of x, then y, then z.
constexpr std::array<VtkFace, 6> kVoxel{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
constexpr std::array<VtkFace, 5> kWedge{{{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
constexpr std::array<VtkFace, 5> kPyramid{{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};

}  // namespace

const VtkCellType* find_vtk_cell_type(int type) {
  const auto found = std::lower_bound(kTypes.begin(), kTypes.end(), type,
                                      [](const VtkCellType& row, int number) { return row.type < number; });
  return found != kTypes.end() && found->type == type ? &*found : nullptr;
}

int vtk_corner_count(int straight) {
  const VtkCellType* row = find_vtk_cell_type(straight);
  return row == nullptr ? 0 : row->points;
}

std::span<const VtkFace> vtk_faces(int straight) {
  switch (straight) {
    case 10:
      return kTet;
    case 11:
      return kVoxel;
    case 12:
      return kHexahedron;
    case 13:
      return kWedge;
    case 14:
      return kPyramid;
    default:
      return {};
  }
}

}  // namespace taxel
