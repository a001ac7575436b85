// Contact, sensing and motion against closed forms: the numbers of `taxel validate` and of docs/validation.md. Sources
// are Elandt et al. 2019 and elementary integrals; each derivation is at its function. A1 to A8 are static contact, B1
// to B3 sensing, A9 the motion of bodies, A10 friction that sticks, A11 to A14 rolling, spinning and impact, A15
// pressure laws.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/validate/setups.h"
#include "core/base/page/chart.h"

namespace taxel {

enum class Relation { equal, at_most, at_least };

/// One quantity of one case against its closed form.
struct ClosedFormCheck {
  std::string form;      ///< "A1"
  std::string setting;   ///< bodies, sizes, depth
  std::string quantity;  ///< "force, mean of 200"
  std::string unit;      ///< "1" for a number without a unit
  double computed = 0;   ///< mean over the poses, or the value with the largest error
  double exact = 0;      ///< value of the closed form, or the limit of an inequality
  /// Relative to `exact`. For an inequality the amount by which it is violated, or 0.
  double error = 0;
  double bound = 0;  ///< largest allowed error
  Relation relation = Relation::equal;
  [[nodiscard]] bool pass() const { return error <= bound; }
};
using ClosedFormChecks = std::vector<ClosedFormCheck>;

/// The case that several checks share.
struct CheckedCase {
  std::string form, setting;

  /// Returns the check that `computed` is at most, or at least, `limit`.
  [[nodiscard]] ClosedFormCheck limit(const std::string& quantity, const std::string& unit, double computed,
                                      Relation relation, double limit) const;
};

/// Relative errors of one quantity over many poses.
class Statistic {
 public:
  void add(double computed, double exact);
  /// Returns the means of the computed values, the exact values and the absolute errors.
  [[nodiscard]] ClosedFormCheck mean(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                     double bound) const;
  /// Returns the values with the largest error.
  [[nodiscard]] ClosedFormCheck worst(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                      double bound) const;
  [[nodiscard]] double mean_error() const { return error_sum_ / count_; }

 private:
  double computed_sum_ = 0, exact_sum_ = 0, error_sum_ = 0;
  double worst_computed_ = 0, worst_exact_ = 0;
  double worst_error_ = std::numeric_limits<double>::quiet_NaN();  ///< before the first pose
  int count_ = 0;
};

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

/// A15: pressure laws, e/(1 - k e) and a table, in the bodies of A1, A2, A4 and A8, against integrals of the law.
ClosedFormChecks validate_pressure_laws();

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

// A9: the motion of bodies in hydroelastic contact, with each of MuJoCo's integrators.

inline constexpr const char* kIntegrators[] = {"Euler", "RK4", "implicit", "implicitfast", "discrete"};

/// Returns a soft block on a slope. The floor is horizontal and gravity is tilted instead. The block starts at about
/// the depth at which it rests.
SoftOnFloor block_on_slope(const char* integrator, double theta);

/// Checks that a soft ball comes to rest at the depth x with F(x) = m g (A1).
ClosedFormChecks validate_rest_depth();
/// Checks that a soft ball that hits the floor without gravity rebounds with the speed of Hunt and Crossley, which is
/// less than 1/d.
ClosedFormChecks validate_rebound();
/// Checks that a ball that bounces and slides loses energy from flight to flight for d > 0.
ClosedFormChecks validate_energy();
/// Checks the motion of a block on a slope: a steady creep of vs tan(pi tan(theta)/(2 mu)) if tan(theta) < mu,
/// otherwise an acceleration of g (sin(theta) - mu cos(theta)).
ClosedFormChecks validate_slope();

/// Runs all of the above. Takes some seconds.
ClosedFormChecks validate_dynamics();

// A10: friction that sticks, against the brush model.

/// Checks the sticking part, the friction and the hysteresis of a soft ball on a plane under a growing displacement.
ClosedFormChecks validate_brush();
/// Checks with each integrator that a block on a slope stays where it is, holds just below the angle of friction, and
/// slides just above.
ClosedFormChecks validate_held_block();

/// Runs both. Takes some seconds.
ClosedFormChecks validate_sticking();

// A11 to A14: rolling, spinning and impact.

/// A11: a soft ball that slides on a rigid plane until it rolls. Its contact is flat and lies at the height R - x below
/// its centre, so it rolls with v = w (R - x), not w R.
ClosedFormChecks validate_rolling();
/// A12: the friction torque of a rigid disc that spins in a soft half-space at the depth x: (2/3) mu p pi R^3 of its
/// base, and of its wall, on which the pressure falls from p to 0, 1.5 x/R times as much.
ClosedFormChecks validate_spinning();
/// A13: a rolling ball with dissipation: the pressure is p0 (1 + d w s) at the distance s ahead of the middle, so the
/// torque d w J resists, J = pi integral of p0 r^3 dr over the contact's radius, and w falls exponentially.
ClosedFormChecks validate_rolling_resistance();
/// A14: a ball thrown at a plane, without dissipation and gravity: largest depth and force, duration of the contact and
/// speed of the rebound, by the work of F(x) (A1).
ClosedFormChecks validate_impact();

/// Runs A11 to A14. Takes some seconds.
ClosedFormChecks validate_rolling_and_impact();

}  // namespace taxel
