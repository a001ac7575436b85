// Contact against closed forms: what the kernel computes, what the integral gives, how far apart they are. These are
// the numbers of `taxel validate` and of docs/validation.md. Sources: Elandt et al. 2019 and elementary integrals, each
// with its derivation in validation.cpp.
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// One quantity of one case.
struct ClosedFormCheck {
  std::string form;      ///< "A1"
  std::string setting;   ///< bodies, sizes, depth, how many poses
  std::string quantity;  ///< "force, mean of 200 directions"
  std::string unit;
  double computed = 0;  ///< mean over the poses, or the pose of the largest error
  double exact = 0;
  double error = 0;  ///< relative to `exact`
  double bound = 0;  ///< largest error allowed
  [[nodiscard]] bool pass() const { return error <= bound; }
};

/// A1: soft sphere, p = E (1 - r/R), on a rigid plane; F = pi E x^2 (1 - 2x/(3R)), area pi (2Rx - x^2), p_max = E x/R.
std::vector<ClosedFormCheck> validate_soft_sphere_on_plane();
/// A2: rigid sphere in a soft half-space, p = kappa depth; F = kappa pi x^2 (R - x/3), area 2 pi R x.
std::vector<ClosedFormCheck> validate_sphere_in_half_space();
/// A3: a rigid cube in a soft half-space at any pose: F = kappa V of the submerged part, through its centroid.
std::vector<ClosedFormCheck> validate_polyhedron_in_half_space();

/// All of the above, in this order. Takes about a second.
std::vector<ClosedFormCheck> validate_all();

}  // namespace taxel
