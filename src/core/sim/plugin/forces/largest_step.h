// The largest time step at which a contact is stable. Its stiffness is integrated explicitly.
//
// Near the present state a pair obeys V' = -A (K x + S V), where A = J M^-1 J^T is its inverse inertia, K the stiffness
// of the contact and S its damping (hydro/contact_stiffness.h, hydro/traction.h). A step V+ = V - h A (K x + S V+),
// x+ = x + h V+ is stable if h^2 lambda < 4 + 2 h sigma in every mode, with the eigenvalues lambda of A K and sigma of
// A S; that is, if no eigenvalue of A (h^2 K - 2 h S) reaches 4. A Runge-Kutta step of a spring is stable up to h^2
// lambda = 8, but a contact that begins or ends within such a step can gain energy from 4 on.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

/// The linearised dynamics of one contact.
struct ContactMode {
  Matrix6 inverse_inertia{};  ///< A, symmetric, may be singular
  Matrix6 stiffness{};        ///< K, symmetric
  Matrix6 damping{};          ///< S, symmetric
};

/// Upper limit of h^2 lambda - 2 h sigma for a stable step.
inline constexpr double kStepLimit = 4;

/// Returns `timestep` if it is stable, otherwise the largest stable time step below it [s].
double largest_stable_step(const ContactMode& mode, double timestep);

/// Returns an upper bound of the eigenvalues of A K for every contact with this linear stiffness [N/m] whose points are
/// at most `reach` [m] from the origin.
double stiffest_mode_bound(const Matrix6& inverse_inertia, double linear_stiffness, double reach);

}  // namespace taxel
