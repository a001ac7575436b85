// The contact surface of two declared bodies, from poses alone.
#pragma once

#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

/// As the body of the two finds it that computes the pair: `other` if it is mirrored (PairRole). X_WM, X_WO: of the
/// bodies' frames; `out` in that of `self`.
void intersect_bodies(const BodyContacts& self, const BodyContacts& other, bool mirrored, const Pose& X_WM,
                      const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace);

}  // namespace taxel
