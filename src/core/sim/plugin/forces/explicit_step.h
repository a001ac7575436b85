// Contacts whose stiffness is integrated explicitly: the largest time step at which they are stable, and the energy
// that a step may release.
//
// Near the present state a pair obeys V' = -A (K x + S V), where A = J M^-1 J^T is its inverse inertia, K the stiffness
// of the contact and S its damping (hydro/contact_stiffness.h, hydro/traction.h). A step V+ = V - h A (K x + S V+),
// x+ = x + h V+ is stable if h^2 lambda < 4 + 2 h sigma in every mode, with the eigenvalues lambda of A K and sigma of
// A S; that is, if no eigenvalue of A (h^2 K - 2 h S) reaches 4. A Runge-Kutta step of a spring is stable up to h^2
// lambda = 8, but a contact that begins or ends within such a step can gain energy from 4 on.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

// Functions of six by six matrices.

inline Matrix6 transposed(const Matrix6& A) {
  Matrix6 T{};
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c) T[c][r] = A[r][c];
  return T;
}

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

// The energy of a contact in explicit steps.
//
// A step of the semi-implicit Euler method, V+ = V + h A F(x), x+ = x + h V+, preserves KE + U + h F.V/2 to second
// order, with the kinetic energy KE and the elastic energy U (Hairer, Lubich, Wanner 2003). A contact begins and ends
// between two steps, and there the error is of first order. Where it begins, the body comes too deep without a force,
// and loses up to a quarter of h^2 k/m of its energy; where it ends, the force of the last step pushes for too long,
// and the body gains as much. The force of a step adds h F.(V + V+)/2 to KE. So it is limited to U + h F.V/2, all that
// the contact has: then no contact ends with more energy than it began with, up to the second order. A step in which
// the bodies remain in contact is hardly ever limited, and one on a linear spring never.

/// Returns the power of a wrench, force . velocity + torque . angular velocity [W].
double power(const Wrench& w, const Twist& V);

/// Returns the largest s <= 1 for which the wrench s w adds at most `left` joules to the kinetic energy, or the s that
/// adds least. V is the twist at the beginning of the step and V_end that at its end with the whole wrench, which
/// changes by h A (s - 1) w.
double release_share(double left, const Wrench& w, const Twist& V, const Twist& V_end, const Matrix6& A,
                     double timestep);

/// Returns a bound of the growth of the stiffness until the motion has become elastic energy, at least 1. `held` is the
/// present energy U, w the present wrench, and V the motion. Of the motion it counts P^2/(2 w.A w), P = w.V < 0: the
/// kinetic energy that w alone can take. With a force like x^n, U is like x^(n+1) and the stiffness like
/// U^((n-1)/(n+1)): at most like the square root of U up to n = 3, a corner.
double stiffness_growth(double held, const Wrench& w, const Twist& V, const Matrix6& A);

}  // namespace taxel
