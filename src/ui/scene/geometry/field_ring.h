// The boundary of a receptive field on the skin: where the sphere around the taxel's centre cuts the mesh.
#pragma once

#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

/// A short straight piece of the boundary, on one face.
struct RingPiece {
  dvec3 a{0}, b{0};  ///< [m], frame of the mesh; on the sphere and on the face
  int face = -1;
};

/// Intersection of the sphere |x - center| = radius with the faces whose normal is less than `max_angle_deg` from
/// `normal`: circular arcs in each face's plane, cut into pieces of at most `step_deg` of their circle.
/// Looks only at the faces near the sphere. Pieces in no useful order, the same each time.
std::vector<RingPiece> field_ring(const MeshIndex& skin, const dvec3& center, double radius, const dvec3& normal,
                                  double max_angle_deg, double step_deg = 6.0);

/// The rings of a taxel: of itself, or of each of its subtaxels.
std::vector<RingPiece> taxel_rings(const MeshIndex& skin, const Taxel& taxel, const ReceptiveFieldRule& rule,
                                   double step_deg = 6.0);

}  // namespace taxel::ui
