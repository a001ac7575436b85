// Static contact and sensing against closed forms: the numbers of `taxel validate` and of docs/validation.md. The
// motion, A9, is in dynamics.h, friction that sticks, A10, in sticking.h, rolling and impact, A11 to A14, in rolling.h.
// Sources are Elandt et al. 2019 and elementary integrals; each derivation is at its function.
#pragma once

#include "app/validate/closed_form.h"
#include "core/base/page/chart.h"

namespace taxel {

/// A1: soft sphere, p = E (1 - r/R), on a rigid plane; F = pi E x^2 (1 - 2x/(3R)), area pi a^2, a^2 = 2Rx - x^2, p_max
/// = E x/R. Includes the order of convergence with finer tessellations.
ClosedFormChecks validate_soft_sphere_on_plane();
/// A2: rigid sphere in a soft half-space, p = kappa depth; F = kappa pi x^2 (R - x/3), area 2 pi R x.
ClosedFormChecks validate_sphere_in_half_space();
/// A3: a rigid cube in a soft half-space at any pose, if all faces count: F = kappa V of the submerged part, through
/// its centroid.
ClosedFormChecks validate_polyhedron_in_half_space();
/// A4: soft box on a rigid plane; F = (E/H)(x L1 L2 - x^2 (L1 + L2) + 4 x^3/3).
ClosedFormChecks validate_soft_box_on_plane();
/// A5: soft cylinder standing on a rigid plane; F = pi E (R^3 - (R - x)^3)/(3H).
ClosedFormChecks validate_standing_cylinder();
/// A6: soft cylinder lying on a rigid plane, per length; F = E (a - (h^2/R) asinh(a/h)), h = R - x, a^2 = R^2 - h^2.
ClosedFormChecks validate_lying_cylinder();
/// A7: two soft spheres; the rim is the lens circle, on the axis p0 = x kA kB/(kA + kB), k = E/R.
ClosedFormChecks validate_two_soft_spheres();
/// A8: a soft box on a soft slab; p = x/(HA/EA + HB/EB) if both are pressed only from above; rigid in the limit.
ClosedFormChecks validate_stacked_slabs();

/// B1: uniformity of the samples by score_samples(): distances to the nearest sample, Voronoi areas, largest empty
/// circle.
ClosedFormChecks validate_samples();
/// B2: geodesic distances on a polyhedral cylinder, which unrolls into a plane: d^2 = du^2 + dz^2.
ClosedFormChecks validate_geodesics();
/// B3: the mean of a linear pressure, weighted by (r - d)^2 over a disc on a flat patch, is the pressure at the centre:
/// with samples of equal weight and of Voronoi areas, 25, 100 and 400 for each taxel.
ClosedFormChecks validate_weighted_mean();

/// Returns a picture of the polished samples of B1 on the pad side of the fingertip, coloured by the distance to the
/// nearest one, and how often each distance occurs, polished and in a preview.
Chart samples_chart();
/// Returns the samples of B1 on the fingertip, as CSV with a header: x,y,z,rho,area,quality, with rho and
/// area of score_samples().
std::string samples_csv();

/// Runs A1 to A8 and B1 to B3 in this order. Takes some seconds.
ClosedFormChecks validate_statics();

/// Two soft spheres in contact, for A7.
struct TwoSpheres {
  double radius_A = 0, modulus_A = 0, radius_B = 0, modulus_B = 0;
  double depth = 0;  ///< radius_A + radius_B - distance of the centres [m]
};
struct TwoSpheresContact {
  double rim_radius = 0, axis_pressure = 0, force = 0, area = 0;
};
/// Returns the contact by quadrature over the radius, with a relative error of 1e-9.
TwoSpheresContact two_spheres_contact(const TwoSpheres& spheres);

}  // namespace taxel
