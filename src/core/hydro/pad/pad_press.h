// Computes the error of the pressure below the skin of a pad.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A face of the skin, given by its tet and the opposite corner.
struct SkinFace {
  int tet, corner;
};

/// Returns all faces of the skin that have a tet, in the order of the tets.
std::vector<SkinFace> skin_faces(const PressureField& field);

/// Finds the pressures [Pa] at the ascending `depths` [m] along the normal below a point x of a skin face, from tet to
/// tet; -1 if no tet is reached.
void pressures_below(const PressureField& field, const SkinFace& face, const dvec3& x, std::span<const double> depths,
                     std::span<double> pressures);

/// Returns the errors of presses of 0.1, 0.25, 0.5 and 1 thickness. 1024 points of the skin, each at random in its own
/// part of the area, are followed straight inward from tet to tet. Where the tets reach the depth d of the press, the
/// pressure p there is divided by E/H times the distance to the skin. Mean and deviation of this ratio are computed at
/// the first two depths only, and without points that are less than d/2 away from the skin there, as near sharp edges.
/// Deterministic. Cost: two closest-point queries per point.
std::vector<FieldReport::PressError> press_errors(const MeshIndex& index, const PressureField& field, double modulus,
                                                  double thickness);

}  // namespace taxel
