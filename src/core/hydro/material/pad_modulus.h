// Modulus of a pad from a data sheet: Young's modulus, Poisson's ratio and thickness of an elastic layer.
//
// A pad is a Winkler foundation, p = modulus min(depth, H)/H. An elastic layer is one only where the contact is much
// wider than the layer is thick. Elsewhere the modulus with the same force depends on the radius of the contact, and
// the functions below say by how much.
#pragma once

#include <optional>
#include <vector>

namespace taxel {

// Contact of a rigid ball or a long rigid cylinder with a linearly elastic layer on a rigid base, without friction.
//
// The contact is an integral equation of the second kind, exact for every thickness and every Poisson's ratio below
// 0.5: Lebedev and Ufliand 1958 for the ball; the cylinder is the same in the plane. The compliance Z(xi) of a layer
// against that of a half-space, xi the wave number times the thickness, is that of Johnson 1985, Contact Mechanics,
// section 5.8. Everything here is without dimension: lengths are over the thickness H, pressures over E/(1 - nu^2), and
// the body's radius R is scaled out, because a paraboloid with radius R has depth and force that fall as 1/R.

/// How a layer is held on its rigid base.
enum class LayerBase {
  bonded,  ///< no point of the base moves
  sliding  ///< the base is free of friction
};

/// The rigid body that is pressed into the layer.
enum class PressedBody {
  ball,
  cylinder  ///< long, lying; its forces are per length
};

/// Compliance of a layer over that of a half-space for pressures with the wave number xi/H. Near xi = 0 it is
/// (E/(1 - nu^2)) / (2 M) xi, M the modulus of a thin layer; towards infinity it is 1.
double layer_compliance(double xi, double poisson, LayerBase base);

/// One press in units of the header.
struct LayerPress {
  double depth = 0;  ///< depth R / H^2 [-]
  double force = 0;  ///< ball: F R / (E* H^3), cylinder: F' R / (E* H^2), E* = E/(1 - nu^2) [-]
};
/// Solves for a press with a radius of contact a (cylinder: half the width), given as a/H from 0.01 to 40.
LayerPress press_layer(double radius, double poisson, LayerBase base, PressedBody body);

/// Radius of the overlap of the undeformed shapes over H: sqrt(2 R depth)/H. It is the radius of the contact surface of
/// a pad of this program, where the skin stays flat outside.
double overlap_radius(const LayerPress& press);

/// Modulus over E* of the pad p = modulus depth/H that has the same force at the same depth.
double matching_modulus(const LayerPress& press, PressedBody body);

/// Returns the press whose overlap_radius() is `radius`, from 0.02 to 20.
LayerPress press_with_overlap(double radius, double poisson, LayerBase base, PressedBody body);

/// An elastic layer on a rigid base, in SI units.
struct ElasticLayer {
  double youngs = 0;     ///< Young's modulus E [Pa]
  double poisson = 0;    ///< Poisson's ratio nu, at least 0 and less than 0.5
  double thickness = 0;  ///< H [m]
  LayerBase base = LayerBase::bonded;
};
/// Throws Error("", "youngs", "poisson" or "thickness", message) if a value is out of its range.
void check_layer(const ElasticLayer& layer);

/// Modulus of a layer that is thin against the contact [Pa]. Bonded: (1 - nu) E / ((1 + nu)(1 - 2 nu)), which has no
/// limit towards nu = 0.5; sliding: E / (1 - nu^2) (Johnson 1985, section 5.8).
double thin_layer_modulus(const ElasticLayer& layer);

/// Largest error of force up to which a modulus counts as right.
inline constexpr double kModulusTolerance = 0.1;
/// Radii of contact over the thickness between which a modulus is computed.
inline constexpr double kSmallestRadius = 0.05, kLargestRadius = 20.0;

/// Modulus with the force of linear elasticity at a contact of this radius [Pa]. The radius [m] is that of the contact
/// surface in this program: sqrt(2 R depth) of a ball with radius R, half the width for a cylinder. Throws as
/// check_layer() does, or Error("", "contact_radius", message) outside of kSmallestRadius to kLargestRadius.
double modulus_at_contact(const ElasticLayer& layer, double contact_radius, PressedBody body);

/// Error of a modulus at one radius of contact.
struct ModulusError {
  double contact_radius = 0;  ///< [m]
  double right_modulus = 0;   ///< modulus_at_contact() [Pa]
  double force_error = 0;     ///< (force by the modulus - right force) / right force
};

/// A modulus, and how far it holds.
struct PadModulus {
  double modulus = 0;     ///< [Pa]
  double thin_layer = 0;  ///< thin_layer_modulus() [Pa]
  /// Radii of contact with a force error of at most kModulusTolerance [m], around the given radius, or up to
  /// kLargestRadius thicknesses; nothing if no radius has.
  struct Range {
    double low = 0, high = 0;
  };
  std::optional<Range> holds;
  std::vector<ModulusError> errors;  ///< at 1/2, 1, 2 and 5 thicknesses
  /// Smallest Poisson's ratio from which on the thin-layer modulus gives a force that is too large by more than
  /// kModulusTolerance, at the given radius or at 2 thicknesses; nothing if it never does.
  std::optional<double> poisson_limit;
  double poisson_limit_radius = 0;  ///< radius of contact for poisson_limit [m]
};
/// Computes the modulus at a radius of contact, or of a thin layer. Throws as modulus_at_contact() does.
PadModulus pad_modulus(const ElasticLayer& layer, std::optional<double> contact_radius, PressedBody body);

}  // namespace taxel
