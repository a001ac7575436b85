#include "core/sim/plugin/pairs/pair_surface.h"

namespace taxel {

void intersect_bodies(const BodyContacts& self, const BodyContacts& other, bool mirrored, const Pose& X_WM,
                      const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace) {
  if (!mirrored) {
    intersect(*self.body(), *other.body(), X_WM, X_WO, out, workspace);
    return;
  }
  ContactSurface theirs;
  intersect(*other.body(), *self.body(), X_WO, X_WM, theirs, workspace);
  mirror(theirs, RigidTransform(X_WM.inverse() * X_WO), out);
}

}  // namespace taxel
