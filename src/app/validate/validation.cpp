#include "app/validate/validation.h"

namespace taxel {

ClosedFormChecks validate_statics() {
  ClosedFormChecks all;
  for (const auto& validate :
       {validate_soft_sphere_on_plane, validate_sphere_in_half_space, validate_polyhedron_in_half_space,
        validate_soft_box_on_plane, validate_standing_cylinder, validate_lying_cylinder, validate_two_soft_spheres,
        validate_stacked_slabs, validate_samples, validate_geodesics, validate_weighted_mean}) {
    const ClosedFormChecks checks = validate();
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

}  // namespace taxel
