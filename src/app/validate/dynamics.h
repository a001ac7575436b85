// A9: the motion of bodies in hydroelastic contact, with each of MuJoCo's integrators, against closed forms.
#pragma once

#include "app/validate/closed_form.h"
#include "app/validate/soft_on_floor.h"

namespace taxel {

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

}  // namespace taxel
