// The boundary of a Euclidean receptive field: the intersection of the skin with the sphere around the taxel's centre.
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

/// Returns the intersection of the sphere |x - center| = radius with the faces whose normal is less than
/// `max_angle_deg` from `normal`. It consists of circular arcs in the planes of the faces, divided into pieces of at
/// most `step_deg` of their circle. Only faces near the sphere are tested. The order of the pieces has no meaning but
/// is always the same.
std::vector<RingPiece> field_ring(const MeshIndex& skin, const dvec3& center, double radius, const dvec3& normal,
                                  double max_angle_deg, double step_deg = 6.0);

/// Returns the rings of a taxel: its own ring, or the rings of its subtaxels.
std::vector<RingPiece> taxel_rings(const MeshIndex& skin, const Taxel& taxel, const ReceptiveFieldRule& rule,
                                   double step_deg = 6.0);

}  // namespace taxel::ui
