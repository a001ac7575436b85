// The contact surface of two declared bodies, from poses alone.
#pragma once

#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

/// Computes the contact surface as the body that computes the pair does, so the result has the same bits. That body is
/// `other` if the pair is mirrored (PairRole), otherwise `self`. X_WM and X_WO are the poses of the frames of `self`
/// and `other`; `out` is in the frame of `self`.
void intersect_bodies(const BodyContacts& self, const BodyContacts& other, bool mirrored, const Pose& X_WM,
                      const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace);

}  // namespace taxel
