// The friction of the bristles of one contact in one state, as a field of traction. Plain values.
#pragma once

#include <vector>

#include "core/hydro/friction/bristles.h"

namespace taxel {

/// The traction of each bristle at its root.
struct StickingFriction {
  struct Root {
    dvec3 place{0};     ///< material point of the skin, frame A [m]
    dvec3 normal{0};    ///< unit normal that pushes A
    double area = 0;    ///< area of contact that the root bears [m^2]
    dvec3 traction{0};  ///< friction on A divided by the area [Pa]
    bool slips = false;
  };
  std::vector<Root> roots;
  double reach = 0;  ///< length s of the shares, see BristleSearch::shares() [m]

  /// Returns the traction at a point of the contact surface: that of the roots by their shares, so that its integral is
  /// the friction of the contact, as far as the roots resolve its edge.
  [[nodiscard]] dvec3 traction_at(const dvec3& x) const;
  /// Returns the share of the roots at a point that slip, from 0 (all stick) to 1.
  [[nodiscard]] double slip_at(const dvec3& x) const;
};

/// Returns the friction of the bristles of a contact that moves with V_BA.
StickingFriction sticking_friction(const BristleContact& contact, const BristleSkin& skin, const BristleLaw& law,
                                   const Twist& V_BA);

/// Returns the friction on body B, in the frame of B. The roots are the same material points of A.
StickingFriction mirrored(const StickingFriction& on_A, const RigidTransform& X_BA);

}  // namespace taxel
