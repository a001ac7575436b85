// The largest time step at which a contact's stiffness, which enters explicitly, does not run away.
//
// Near the present state a pair obeys V' = -A (K x + S V), A = J M^-1 J^T its inverse inertia, K the contact's
// stiffness and S its damping (hydro/contact_stiffness.h, hydro/traction.h). A step V+ = V - h A (K x + S V+), x+ = x +
// h V+ is stable while h^2 lambda < 4 + 2 h sigma in every mode, lambda of A K and sigma of A S: while no eigenvalue of
// A (h^2 K - 2 h S) reaches 4. Runge and Kutta's step without damping holds until h^2 lambda = 8.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

struct ContactMode {
  Matrix6 inverse_inertia{};  ///< A, symmetric, may be singular
  Matrix6 stiffness{};        ///< K, symmetric
  Matrix6 damping{};          ///< S, symmetric
};

/// What h^2 lambda - 2 h sigma must stay below.
inline constexpr double kEulerLimit = 4, kRungeKuttaLimit = 8;

/// `timestep` where that is stable, else the largest stable step below it [s].
double largest_stable_step(const ContactMode& mode, double limit, double timestep);

/// No eigenvalue of A K is larger, for contacts of which no more is known than this.
double stiffest_mode_bound(const Matrix6& inverse_inertia, double linear_stiffness, double reach);

}  // namespace taxel
