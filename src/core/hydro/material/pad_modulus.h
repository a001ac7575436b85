// Modulus of a pad from a data sheet: Young's modulus, Poisson's ratio and thickness of an elastic layer.
//
// A pad is a Winkler foundation, p = modulus min(depth, H)/H. An elastic layer is one only where the contact is much
// wider than the layer is thick. Elsewhere the modulus with the same force depends on the radius of the contact, and
// the functions below say by how much.
#pragma once

#include <optional>
#include <vector>

#include "core/hydro/material/layer_contact.h"

namespace taxel {

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
