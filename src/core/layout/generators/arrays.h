// Regular arrays of taxels: rows and columns in a plane or projected onto a skin, rings and helices around an axis, and
// the spiral of a sunflower's seeds.
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

/// A lattice of equal triangles over one side of a skin. Lengths in metres.
struct HexagonalCover {
  double pitch = 0.004;         ///< distance between neighbours in the plane
  double max_slope_deg = 60;    ///< largest angle between the skin's normal and `normal`, up to 90
  double radius = 0.004;        ///< radius of the receptive fields
  dvec3 center{0};              ///< a point of the lattice
  dvec3 along_row{1, 0, 0};     ///< direction of the rows; any length
  dvec3 normal{0, 0, 1};        ///< direction to which the covered side faces; any length
  std::vector<int> faces = {};  ///< only these faces of the skin, ascending; all if empty
};

/// Returns taxels at the points of the lattice, row by row (ids from 0), projected along -normal from outside onto the
/// first intersection with the skin, with the smooth normals there. Rows are pitch sqrt(3)/2 apart, and every second
/// one is shifted by half a pitch. On a slope s taxels are 1 / cos(s) farther apart. Points over no skin, over a
/// steeper slope or over another face have no taxel. Throws Error that names the parameter, or if no taxel is left.
std::vector<Taxel> hexagonal_cover(const HexagonalCover& cover, const MeshIndex& skin);

/// A number of taxels around an axis. Heights are in metres along `axis` from `origin`. The first taxel is in the half
/// plane of `first`; the others follow counter-clockwise about the axis.
struct AroundAxis {
  int count = 1;
  dvec3 origin{0};
  dvec3 axis{0, 0, 1};    ///< any length
  dvec3 first{1, 0, 0};   ///< any length, not parallel to the axis
  double radius = 0.005;  ///< radius of the receptive fields [m]
};

/// Returns `count` taxels at equal angles on the outermost skin at `height`, with ids 0 ... count - 1. Their distances
/// are equal if the section is round about the axis. Throws Error that names the parameter, or the taxel whose ray
/// toward the axis misses the skin.
std::vector<Taxel> ring(const AroundAxis& around, double height, const MeshIndex& skin);

/// Returns `count` taxels (at least 2) from `bottom` to `top` in equal steps of height and angle. `turns` is the number
/// of turns, not 0; negative turns are clockwise. Throws the errors of ring().
std::vector<Taxel> helix(const AroundAxis& around, double bottom, double top, double turns, const MeshIndex& skin);

/// A disc outside of the skin, and the direction of its projection.
struct Spiral {
  int count = 1;
  dvec3 center{0};            ///< centre of the disc, outside of the skin [m]
  dvec3 direction{0, 0, -1};  ///< direction of projection, the disc's normal; any length
  double disc_radius = 0.01;  ///< [m]
  double radius = 0.005;      ///< radius of the receptive fields [m]
};

/// Returns taxels of equal area each (Vogel 1979, "A better way to construct the sunflower head"). Taxel k is at
/// r = R sqrt((k + 1/2) / N), theta = k pi (3 - sqrt 5) about -direction on the disc, and then at the first
/// intersection of the ray along `direction` with the skin. Throws Error that names the parameter, or the taxel whose
/// ray misses the skin.
std::vector<Taxel> sunflower(const Spiral& spiral, const MeshIndex& skin, Beyond beyond = Beyond::refuse);

}  // namespace taxel
