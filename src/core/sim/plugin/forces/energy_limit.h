// The energy of a contact in explicit steps.
//
// A step of the semi-implicit Euler method, V+ = V + h A F(x), x+ = x + h V+, preserves KE + U + h F.V/2 to second
// order, with the kinetic energy KE and the elastic energy U (Hairer, Lubich, Wanner 2003). A contact begins and ends
// between two steps, and there the error is of first order. Where it begins, the body comes too deep without a force,
// and loses up to a quarter of h^2 k/m of its energy; where it ends, the force of the last step pushes for too long,
// and the body gains as much. The force of a step adds h F.(V + V+)/2 to KE. So it is limited to U + h F.V/2, all that
// the contact has: then no contact ends with more energy than it began with, up to the second order. A step in which
// the bodies remain in contact is hardly ever limited, and one on a linear spring never.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

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
