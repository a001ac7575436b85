// Computes the wrench of a contact surface: pressure with Hunt-Crossley damping, and regularised Coulomb friction.
#pragma once

#include <array>
#include <optional>

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

/// Linear velocity [m/s] and angular velocity [rad/s].
struct Twist {
  dvec3 linear{0}, angular{0};
};
/// Force [N] and torque [N m].
struct Wrench {
  dvec3 force{0}, torque{0};
};
using Matrix6 = std::array<std::array<double, 6>, 6>;

/// Regularisation speed of friction [m/s]: |t| = (2/pi) mu p atan(v/vs).
inline constexpr double kSlipSpeed = 1.0e-4;

/// Returns (2/pi) atan(v/vs)/v, with its limit 2/(pi vs) at rest [s/m].
double slip_factor(double speed);

struct PairProperties {
  double dissipation = 0;  ///< d* [s/m]
  double friction = 0;     ///< mu
};
/// Returns the properties of a pair: d* = (Eb da + Ea db)/(Ea + Eb), or the dissipation of the soft body if the other
/// one is rigid; mu = 2 mu1 mu2/(mu1 + mu2), or 0 if both are 0.
PairProperties combine(const Material& a, const Material& b);

/// Returns the friction on A [Pa] at a point with normal n and elastic pressure p0, if A moves with v relative to B: t
/// = -(2/pi) mu p atan(|vt|/vs) vt/|vt|, p = p0 (1 - d vn)+.
dvec3 friction_traction(double p0, const dvec3& n, const dvec3& v, const PairProperties& pair);

/// The wrench on A about A's origin, frame A, for A moving with `V_BA` relative to B (frame A, at A's origin): integral
/// of p n + t with p = p0 (1 - d vn)+, t = -(2/pi) mu p atan(|vt|/vs) vt/|vt|. Exact for linear p0 and d = 0. If
/// requested, `secant` is the symmetric positive semi-definite S with wrench = elastic(p0 where still pushing) - S V:
/// damping and friction written as a secant, for implicit steps.
struct Traction {
  Wrench wrench;
  Wrench elastic;  ///< part of `wrench` that depends on the velocity only through the contact set
  Matrix6 secant{};
};
Traction traction(const ContactSurface& surface, const PairProperties& pair, const Twist& V_BA);

/// Returns elastic - S V.
Wrench secant_wrench(const Wrench& elastic, const Matrix6& S, const Twist& V);

/// Returns the wrench of the elastic pressure p0 n, without velocities.
Wrench pressure_wrench(const ContactSurface& surface);

/// The centre of pressure of one or more contact surfaces: integral of p x dA / integral of p dA, or the centroid of
/// the area if the pressure is zero.
class CenterOfPressure {
 public:
  /// Adds a surface in the frame of the sum.
  void add(const ContactSurface& surface);
  /// Adds a surface whose frame has the pose X_WA in the frame W of the sum.
  void add(const ContactSurface& surface, const Pose& X_WA);
  /// Returns the centre [m]; nothing without a polygon.
  [[nodiscard]] std::optional<dvec3> value() const;

 private:
  dvec3 moment_{0}, area_moment_{0};  // integrals of p x dA [N m] and of x dA [m^3]
  double force_ = 0, area_ = 0;       // integrals of p dA [N] and of dA [m^2]
};
/// Returns the centre of pressure of a surface; 0 if it has no polygon.
dvec3 center_of_pressure(const ContactSurface& surface);

}  // namespace taxel
