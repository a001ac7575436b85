// Friction and damping with the velocity of the end of the step.
//
// A pair's wrench is w(V) = elastic(V) - S(V) V (hydro/traction.h), stiff in V: explicit friction needs steps below
// pi vs/(mu g), 0.06 ms. The step itself, with everything but this wrench known, moves the pair's relative twist to
// V_free + h A w, A = J M^-1 J^T being the inverse inertia that the contact feels. Both together are one equation in
// six unknowns, V = V_free + h A w(V), solved here.
#pragma once

#include <functional>

#include "core/hydro/traction.h"

namespace taxel {

struct ImplicitStep {
  Matrix6 inverse_inertia{};  ///< A, symmetric, may be singular: relative twist per wrench and second
  Twist V_start;              ///< where the search begins: the twist now
  Twist V_free;               ///< twist at the end of the step without this wrench
  double timestep = 0;        ///< h [s]
  double length = 1;          ///< size of the contact: compares [rad/s] with [m/s] [m]
};

struct ImplicitWrench {
  Wrench wrench;
  Twist V_end;          ///< twist at the end of the step with the wrench
  int evaluations = 0;  ///< of the law
  bool converged = false;
};

/// Solves by repeated linear solves with the secant S (each lowers the energy of the step, so they cannot run away:
/// |t| grows less than linearly in |v|), accelerated by Anderson mixing (Walker, Ni 2011). A single linear solve would
/// chatter when sliding stops. Stops when an iteration changes V by less than 1e-7 of what the wrench changed it by, or
/// after 30 evaluations; the result is stable in either case. Every frame is that of the law.
ImplicitWrench solve_implicit_wrench(const ImplicitStep& step, const std::function<Traction(const Twist&)>& law);

}  // namespace taxel
