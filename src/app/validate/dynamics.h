// A9: bodies moved by hydroelastic contact through MuJoCo, under each of its integrators, against closed forms. Part of
// `taxel validate`; the static forms are in project/validation.
#pragma once

#include "app/validate/closed_form.h"

namespace taxel {

/// A soft ball comes to rest where F(x) = m g (A1).
ClosedFormChecks validate_rest_depth();
/// A soft ball thrown at the floor without gravity leaves it with the speed of Hunt and Crossley, never faster than
/// 1/d.
ClosedFormChecks validate_rebound();
/// A ball that bounces and slides loses energy from flight to flight for d > 0.
ClosedFormChecks validate_energy();
/// On a slope, tan(theta) < mu: a steady creep of vs tan(pi tan(theta)/(2 mu)); above: acceleration g (sin - mu cos).
ClosedFormChecks validate_slope();

/// All of the above. Takes some seconds.
ClosedFormChecks validate_dynamics();

}  // namespace taxel
