// Stiffness of a contact: the growth of its elastic wrench when the bodies move against each other.
#pragma once

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/traction.h"

namespace taxel {

/// The wrench on A answers a small motion of A relative to B by -K of it (both about A's origin, frame A):
/// K = integral of the symmetric part of l r^T dA, each of l and r taken as a force at x, with its moment. Where A
/// moves by dx, the place where pA(x - dx) = pB(x) moves along n by gA . dx/|gA - gB|, and with it what pushes of B: l
/// = -gB, r = gA/|gA - gB|; two slabs are springs in series. Against a rigid body l = n, r = g. That the surface turns
/// with the bodies is left out. The surface is that of `a` and `b`, with B's pose X_AB in A.
Matrix6 contact_stiffness(const ContactSurface& surface, const HydroBody& a, const HydroBody& b,
                          const RigidTransform& X_AB);

/// Bounds of K that are known from the surface alone.
struct StiffnessBound {
  double linear = 0;  ///< upper bound of the integral of |l| |r| dA where the gradients are opposed [N/m]
  double reach = 0;   ///< largest distance of a centroid from A's origin [m]
};
StiffnessBound stiffness_bound(const ContactSurface& surface);

}  // namespace taxel
