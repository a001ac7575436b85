// A11 to A14: rolling, spinning and impact in hydroelastic contact, against closed forms.
#pragma once

#include "app/validate/closed_form.h"

namespace taxel {

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
