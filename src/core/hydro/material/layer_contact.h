// Contact of a rigid ball or a long rigid cylinder with a linearly elastic layer on a rigid base, without friction.
//
// The contact is an integral equation of the second kind, exact for every thickness and every Poisson's ratio below
// 0.5: Lebedev and Ufliand 1958 for the ball; the cylinder is the same in the plane. The compliance Z(xi) of a layer
// against that of a half-space, xi the wave number times the thickness, is that of Johnson 1985, Contact Mechanics,
// section 5.8. Everything here is without dimension: lengths are over the thickness H, pressures over E/(1 - nu^2), and
// the body's radius R is scaled out, because a paraboloid with radius R has depth and force that fall as 1/R.
#pragma once

namespace taxel {

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

}  // namespace taxel
