// Meshes made from formulas: MuJoCo's primitive shapes and height fields, and the project's own fingertip.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

TriMesh make_box(const dvec3& half_size);                 ///< 12 triangles
TriMesh make_icosphere(double radius, int subdivisions);  ///< 20 * 4^n triangles, vertices on the sphere
TriMesh make_sphere(double radius, double edge_length);   ///< icosphere with edges of at most edge_length
TriMesh make_capsule(double radius, double half_length, double edge_length);   ///< axis z
TriMesh make_cylinder(double radius, double half_length, double edge_length);  ///< axis z, flat caps
TriMesh make_ellipsoid(const dvec3& semi_axes, double edge_length);

// Round shapes for display, with few triangles: long ones along straight sides. Sizes as above, positive.
TriMesh make_drawn_capsule(double radius, double half_length);
TriMesh make_drawn_cylinder(double radius, double half_length);
TriMesh make_drawn_ellipsoid(const dvec3& semi_axes);

/// Returns the mesh scaled about its centroid so that its volume is `volume`.
TriMesh scaled_to_volume(const TriMesh& mesh, double volume);

/// A human-like robot fingertip: metres, pad towards -y, tip towards +z, base in the plane z = 0, mirror symmetric in
/// x; about 18 x 15.5 x 30.5 mm; closed, smooth, about 2000 triangles. Own design from a superellipse section whose
/// half widths shrink smoothly to the tip.
TriMesh make_fingertip();

/// MuJoCo's `hfield`: a grid of points over [-x, x] x [-y, y], columns along x, rows along y.
struct HeightField {
  int rows = 0, columns = 0;      ///< at least 2 each
  std::vector<double> elevation;  ///< row after row, in units of size.z above z = 0
  dvec3 size{0};                  ///< half extents in x and y, height of elevation 1 in z [m]
  double base = 0;                ///< depth of the body below z = 0 [m]

  bool operator==(const HeightField&) const = default;
};

/// Returns the surface that MuJoCo collides with: two triangles per cell, cut along the diagonal from the lower row and
/// column to the higher ones, closed by vertical sides and a flat base. Throws Error if there are too few rows or
/// columns or a wrong number of elevations, if an elevation is not finite or not above the base, or if a size or the
/// base is not positive.
TriMesh make_height_field(const HeightField& field);

}  // namespace taxel
