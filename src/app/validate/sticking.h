// A10: friction that sticks, against the closed forms of the brush model.
#pragma once

#include "app/validate/closed_form.h"

namespace taxel {

/// Checks the sticking part, the friction and the hysteresis of a soft ball on a plane under a growing displacement.
ClosedFormChecks validate_brush();
/// Checks with each integrator that a block on a slope stays where it is, holds just below the angle of friction, and
/// slides just above.
ClosedFormChecks validate_held_block();

/// Runs both. Takes some seconds.
ClosedFormChecks validate_sticking();

}  // namespace taxel
