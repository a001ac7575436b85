// Material of a body in the hydroelastic model.
#pragma once

#include "core/base/pressure_law.h"

namespace taxel {

/// Construction of the pressure field inside a compliant body.
enum class FieldKind {
  pad,          ///< p = E min(depth, H)/H over a rigid core (default of meshes)
  medial_axis,  ///< p = E depth/H, H the depth of the medial axis (default of primitives)
  star,         ///< tets from the volume centroid, p = E there (the paper's released code)
  tets          ///< a tetrahedral mesh from a file
};

/// Polygons of contact surfaces that count. Along the gradient (hydro/kernel/surface_writer.h) a thin plate feels its
/// near face; with all polygons a closed body in a linear field feels E/H times its volume.
enum class FaceRule { along_gradient, all };

/// Largest number of bristles of a body.
inline constexpr int kMostBristles = 20000;

/// Material parameters in SI units. A body with modulus 0 is rigid.
struct Material {
  FieldKind field = FieldKind::pad;
  double modulus = 0.0;      ///< E, hydroelastic modulus [Pa]
  double thickness = 0.0;    ///< H of a pad or of a half-space [m]; 0 if chosen from the size
  double dissipation = 0.0;  ///< Hunt-Crossley d [s/m]
  double friction = 0.5;     ///< Coulomb coefficient [-]
  FaceRule faces = FaceRule::along_gradient;
  /// Stiffness per area of friction that sticks [Pa/m]; 0 for regularised friction, which has no memory. Sticking
  /// friction is that of the body that computes a contact: a layout or a plugin gives it, other bodies have 0.
  double tangential_stiffness = 0.0;
  int bristles = 1000;  ///< number of points of the skin that remember friction that sticks
  PressureLaw law{};    ///< pressure over E as a function of the strain

  [[nodiscard]] bool compliant() const { return modulus > 0.0; }
  bool operator==(const Material&) const = default;
};

}  // namespace taxel
