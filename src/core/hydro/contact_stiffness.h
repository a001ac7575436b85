// Stiffness of a contact: the growth of its elastic wrench when the bodies move against each other.
#pragma once

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/traction.h"

namespace taxel {

/// Returns the stiffness K: a small motion dX of A relative to B changes the wrench on A by -K dX (both about A's
/// origin, frame A). K is the integral of the symmetric part of l r^T dA, where l and r are treated as forces at x,
/// with their moments. If A moves by dx, the surface pA(x - dx) = pB(x) moves along n by gA . dx/|gA - gB|, and with it
/// the pressure of B, so l = -gB and r = gA/|gA - gB|; two slabs are springs in series. Against a rigid body l = n and
/// r = g. The rotation of the surface with the bodies is neglected. `surface` is the contact surface of `a` and `b`,
/// and X_AB is the pose of B in A.
Matrix6 contact_stiffness(const ContactSurface& surface, const HydroBody& a, const HydroBody& b,
                          const RigidTransform& X_AB);

/// Returns the elastic energy that both bodies hold in their contact [J]: the work that pressed them together. A
/// pressure with a constant gradient g is the divergence of p^2 g/(2 |g|^2), so the integral of p over the overlap is
/// that of p^2 |g . n|/(2 |g|^2) over the surface, for each soft body. Exact in one tet; elsewhere to the order of the
/// depth over the radius of the body. A body with a pressure law holds E W |n . g|/|g|^2 instead, with W the integral
/// of the law over the strain and g the gradient of the strain.
double elastic_energy(const ContactSurface& surface, const HydroBody& a, const HydroBody& b,
                      const RigidTransform& X_AB);

/// Bounds of K that are known from the surface alone.
struct StiffnessBound {
  double linear = 0;  ///< upper bound of the integral of |l| |r| dA where the gradients are opposed [N/m]
  double reach = 0;   ///< largest distance of a centroid from A's origin [m]
};
StiffnessBound stiffness_bound(const ContactSurface& surface);

}  // namespace taxel
