// Stiffness and energy of a contact, from its surface alone.
//
// Where A moves by dx relative to B, the surface pA(x - dx) = pB(x) moves along its normal by gA . dx/|gA - gB|, and
// with it the pressure of B: two slabs are springs in series. Each polygon therefore adds the integral of l r^T, l and
// r the gradients as forces at x with their moments; the middles of edges integrate this polynomial of degree 2
// exactly. The energy is an integral over the surface as well, since a pressure with a constant gradient is the
// divergence of p^2 g/(2 |g|^2).
//
// Pitfalls: pieces beyond the tets know one gradient only, and that of the other pad follows from its length 1 of the
// depth. The factor of back faces is in pressure and gradient, and products would contain it twice. The rotation of the
// surface with the bodies is neglected. Theory: docs/theory/sim.md, "The largest step" and "Energy of a step".
#include "core/hydro/contact_stiffness.h"

#include <algorithm>

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

/// K of a piece of the surface is left right^T, made symmetric.
struct PointStiffness {
  dvec3 left{0}, right{0};
};

/// Returns true if a polygon lies beyond the tets of a pad.
bool is_depth_piece(const ContactPolygon& polygon) {
  return polygon.tet < 0;
}

/// The strain of a body at a pressure [Pa].
double strain_at(const HydroBody& body, double pressure) {
  return body.material.law.strain(pressure / body.material.modulus);
}

/// Gradient of the pressure in a soft body where it has a pressure, frame of the body: that of the linear pressure E e,
/// times the derivative of the law.
dvec3 gradient_in(const HydroBody& body, int tet, double pressure) {
  const double slope = body.law_levels.empty() ? 1 : body.material.law.gradient(strain_at(body, pressure));
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    return slope * soft->field->tets()[static_cast<std::size_t>(tet)].gradient;
  return {0, 0, -slope * std::get<SoftHalfSpace>(body.geometry).stiffness};
}

/// The gradient of a pad beyond its tets, from that of the other body: their difference is along the direction n, and
/// the depth of a pad has a gradient of length 1.
dvec3 gradient_beyond(const HydroBody& body, double pressure, const dvec3& other, const dvec3& n) {
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  const double slope = body.material.law.gradient(strain_at(body, pressure));
  const double k = soft != nullptr && soft->depth ? slope * soft->depth->stiffness() : 0, along = glm::dot(other, n);
  const double squared = along * along - glm::dot(other, other) + k * k;
  return other + (std::sqrt(std::max(0.0, squared)) - along) * n;
}

/// Gradients of the pressures of two soft bodies, frame A.
std::array<dvec3, 2> gradients_of(const ContactPolygon& polygon, const HydroBody& a, const HydroBody& b,
                                  const dmat3& R_AB) {
  const double weight = static_cast<double>(polygon.weight);  // the factor of back faces
  const double p = polygon.pressure / weight;
  const dvec3 own = polygon.gradient / weight;
  if (!is_depth_piece(polygon)) {
    // A polygon of tets and a half-space is in the half-space.
    return {gradient_in(a, polygon.tet, p), R_AB * gradient_in(b, polygon.tet_b >= 0 ? polygon.tet_b : polygon.tet, p)};
  }
  if (a.half_space()) return {gradient_in(a, -1, p), own};
  if (b.half_space()) return {own, R_AB * gradient_in(b, -1, p)};
  return {own, gradient_beyond(b, p, own, -polygon.normal)};
}

PointStiffness stiffness_of(const ContactPolygon& polygon, const HydroBody& a, const HydroBody& b, const dmat3& R_AB) {
  const dvec3 &n = polygon.normal, &g = polygon.gradient;
  if (!a.soft() || !b.soft()) return {n, glm::dot(g, n) < 0 ? -g : g};
  const auto [gA, gB] = gradients_of(polygon, a, b, R_AB);
  const double steepness = glm::length(gA - gB);
  if (!(steepness > 0)) return {};
  return {-gB, static_cast<double>(polygon.weight) * gA / steepness};
}

/// Returns |g . n|/|g|^2, the depth per pressure along the normal [m/Pa]; 0 if the pressure is constant.
double depth_per_pressure(const dvec3& g, const dvec3& n) {
  const double squared = glm::dot(g, g);
  return squared > 0 ? std::abs(glm::dot(g, n)) / squared : 0;
}

/// Returns the depth per pressure of a piece of the surface, the sum of both bodies. The factor of back faces is in
/// pressure and gradient, so it is taken out once.
double compliance_of(const ContactPolygon& polygon, const HydroBody& a, const HydroBody& b, const dmat3& R_AB) {
  if (!a.soft() || !b.soft()) return depth_per_pressure(polygon.gradient, polygon.normal);
  const auto [gA, gB] = gradients_of(polygon, a, b, R_AB);
  return (depth_per_pressure(gA, polygon.normal) + depth_per_pressure(gB, polygon.normal)) /
         static_cast<double>(polygon.weight);
}

/// Returns the energy that a body with a law holds at a piece of the surface: the integral of E W(e) |n . g|/|g|^2, W
/// the integral of the law and g the gradient of the strain e.
double energy_of_law(const ContactSurface& surface, const ContactPolygon& polygon, const HydroBody& body,
                     const dvec3& gradient) {
  const PressureLaw& law = body.material.law;
  const double E = body.material.modulus, weight = static_cast<double>(polygon.weight);
  const double slope = law.gradient(strain_at(body, polygon.pressure / weight));
  double sum = 0;
  for_each_quadrature_point(surface, polygon, kTriangleDegree4, [&](const dvec3& x, double area) {
    const double p = polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
    sum += area * law.energy(strain_at(body, p / weight));
  });
  return weight * E * sum * E * slope * depth_per_pressure(gradient, polygon.normal);
}

/// Returns the energy that both bodies hold at a piece of the surface, if one of them has a law.
double energy_of_laws(const ContactSurface& surface, const ContactPolygon& polygon, const HydroBody& a,
                      const HydroBody& b, const dmat3& R_AB) {
  if (!a.soft() || !b.soft())
    return energy_of_law(surface, polygon, a.soft() ? a : b, polygon.gradient / static_cast<double>(polygon.weight));
  const auto [gA, gB] = gradients_of(polygon, a, b, R_AB);
  return energy_of_law(surface, polygon, a, gA) + energy_of_law(surface, polygon, b, gB);
}

void add_point(const dvec3& x, const PointStiffness& k, double weight, Matrix6& K) {
  const dvec3 m = glm::cross(x, k.left), w = glm::cross(x, k.right);
  const std::array<double, 6> l{k.left.x, k.left.y, k.left.z, m.x, m.y, m.z};
  const std::array<double, 6> r{k.right.x, k.right.y, k.right.z, w.x, w.y, w.z};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) K[i][j] += 0.5 * weight * (l[i] * r[j] + l[j] * r[i]);
}

}  // namespace

Matrix6 contact_stiffness(const ContactSurface& surface, const HydroBody& a, const HydroBody& b,
                          const RigidTransform& X_AB) {
  Matrix6 K{};
  for (const ContactPolygon& polygon : surface.polygons) {
    const PointStiffness k = stiffness_of(polygon, a, b, X_AB.R);
    for_each_triangle(surface, polygon, [&](const dvec3& a0, const dvec3& a1, const dvec3& a2, double area) {
      const double weight = area / 3;  // the middles of the edges: exact for polynomials of degree 2
      add_point(0.5 * (a0 + a1), k, weight, K);
      add_point(0.5 * (a1 + a2), k, weight, K);
      add_point(0.5 * (a2 + a0), k, weight, K);
    });
  }
  return K;
}

double elastic_energy(const ContactSurface& surface, const HydroBody& a, const HydroBody& b,
                      const RigidTransform& X_AB) {
  double sum = 0;
  const bool has_law = !a.law_levels.empty() || !b.law_levels.empty();
  for (const ContactPolygon& polygon : surface.polygons) {
    if (has_law) {
      sum += energy_of_laws(surface, polygon, a, b, X_AB.R);
      continue;
    }
    const double compliance = compliance_of(polygon, a, b, X_AB.R);
    const auto pressure = [&](const dvec3& x) {
      return polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
    };
    for_each_triangle(surface, polygon, [&](const dvec3& a0, const dvec3& a1, const dvec3& a2, double area) {
      const double p0 = pressure(a0), p1 = pressure(a1), p2 = pressure(a2);
      sum += compliance * area / 12 * (p0 * p0 + p1 * p1 + p2 * p2 + p0 * p1 + p1 * p2 + p2 * p0);
    });
  }
  return sum;
}

StiffnessBound stiffness_bound(const ContactSurface& surface) {
  StiffnessBound bound;
  double farthest = 0;
  for (const ContactPolygon& polygon : surface.polygons) {
    bound.linear += polygon.area * glm::length(polygon.gradient);
    farthest = std::max(farthest, glm::dot(polygon.centroid, polygon.centroid));
  }
  bound.reach = std::sqrt(farthest);
  return bound;
}

}  // namespace taxel
