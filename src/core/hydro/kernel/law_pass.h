// The pressure law on a contact surface. The kernels know pressures that are linear in the strain of a body; this pass
// replaces them by those of the body's law.
#pragma once

#include <span>
#include <vector>

#include "core/base/pressure_law.h"
#include "core/hydro/contact_surface.h"

namespace taxel {

/// Number of strains at which polygons are divided.
inline constexpr int kLawLevels = 4;

/// A body's law with its scale. The law must outlive it.
struct ScaledLaw {
  const PressureLaw* law = nullptr;
  double modulus = 0;  ///< E [Pa]

  [[nodiscard]] double at(double linear) const { return modulus * law->pressure(linear / modulus); }
  [[nodiscard]] double slope(double linear) const { return law->gradient(linear / modulus); }
  /// Returns the linear pressure at which at() is p.
  [[nodiscard]] double inverse(double p) const { return modulus * law->strain(p / modulus); }
};

/// The pressures of a surface as a function of those of the kernel, which are linear: by the law of one body or,
/// between two soft bodies, by both laws.
///
/// The kernel finds where straight pieces of the matched body's function T (law_match.h) are equal to the linear
/// pressure of the other body, so at a point p of its surface the two laws give slightly different pressures. The true
/// surface lies a short way along the normal, where they are equal: to first order the pressure there is
/// (s' P + s P')/(s + s'), s and s' the slopes of both pressures along the normal.
struct LawsOfSurface {
  ScaledLaw scale;                   ///< law of the body whose linear pressures the kernel has
  ScaledLaw matched{};               ///< law of the matched body, if there is one
  ScaledLaw pieces{};                ///< LawMatch::pieces(); without a law if there is no matched body
  std::span<const double> ratios{};  ///< for each polygon, s'/s of the kernel's pressures
  std::span<const double> levels{};  ///< linear pressures at which polygons are divided [Pa], ascending
};

/// A corner of a part of a polygon, with its linear pressure E e.
struct LawCorner {
  dvec3 x{0};
  double linear = 0;
};

/// Memory of follow_laws(), kept from step to step.
struct LawMemory {
  std::vector<LawCorner> corners, below, part;
  std::vector<double> factors;  ///< factors of the gradients of a polygon's parts
  NumberBuffer<dvec3> vertices;
  NumberBuffer<double> pressure;
  std::vector<ContactPolygon> polygons;
  std::vector<double> slopes;
  std::vector<double> levels, ratios;  ///< memory of those of LawsOfSurface
};

/// Replaces the linear pressures of a surface by those of the laws. Polygons are divided at the levels; each part has
/// the laws at its vertices and, as its linear pressure, the regression line of the law over its area: force and
/// torque of a part are those of the law, to the degree of the quadrature (4). The line is never negative on the part.
/// `slopes` belong to the last polygons (DepthWorkspace::slopes) and remain so; each is multiplied by the derivative
/// that its polygon's gradient is multiplied by. Costs one visit of each polygon.
void follow_laws(const LawsOfSurface& laws, ContactSurface& surface, std::vector<double>& slopes, LawMemory& memory);

}  // namespace taxel
