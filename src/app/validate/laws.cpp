// Pressure laws, A15: bodies whose pressure is E L(e), against integrals of the law.
#include <fmt/format.h>

#include <cmath>

#include "app/validate/setups.h"
#include "app/validate/validation.h"
#include "core/hydro/quadrature.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;
constexpr int kPresses = 50;

struct NamedLaw {
  const char* name;
  PressureLaw law;
};
const NamedLaw kTestedLaws[] = {
    {"e/(1 - 0.78 e)", {LawKind::stiffening, 0.78, {}}},
    {"a table of 4 points", {LawKind::table, 0, {{0.15, 0.12}, {0.35, 0.4}, {0.6, 0.9}, {1, 2.2}}}}};

Material soft_with(const PressureLaw& law, double thickness, double modulus = kModulus) {
  Material material{thickness > 0 ? FieldKind::pad : FieldKind::medial_axis, modulus, thickness, 0, 0};
  material.law = law;
  return material;
}

/// Returns the integral of f from 0 to `end` by Gauss-Legendre rules on 200 parts, since a table has bends.
template <class F>
double integral_of(double end, const F& f) {
  constexpr int kParts = 200, kNodes = 4;
  QuadratureRule rule;
  for (int i = 0; i < kParts; ++i) add_gauss_legendre(end * i / kParts, end * (i + 1) / kParts, kNodes, rule);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * f(rule.nodes[i]);
  return sum;
}

/// A soft sphere on a rigid plane: the strain is 1 - sqrt(r^2 + (R - x)^2)/R at the distance r from the axis.
ClosedFormCheck press_sphere_of_law(const NamedLaw& tested) {
  constexpr double R = 0.05;
  Press press(make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0.085 * R}, soft_with(tested.law, 0), "sphere"),
              rigid_plane());
  Statistic force;
  for (int i = 0; i < kPresses; ++i) {
    const double x = R * (0.05 + 0.4 * CounterRng(15, static_cast<std::uint64_t>(i)).uniform(3));
    press.at({random_pose(15, i, 0).q, dvec3(0, 0, R - x)}, Pose{});
    force.add(press.force_W().z, integral_of(std::sqrt(2 * R * x - x * x), [&](double r) {
                return 2 * kPi * r * kModulus * tested.law.pressure(1 - std::hypot(r, R - x) / R);
              }));
  }
  const CheckedCase about{"A15", fmt::format("L = {}: the sphere of A1, x/R from 0.05 to 0.45", tested.name)};
  return force.worst(about, "force", "N", 0.03);
}

/// A rigid sphere in a soft half-space: the depth is x - R + sqrt(R^2 - r^2) at the distance r from the axis.
ClosedFormCheck press_half_space_of_law(const NamedLaw& tested) {
  constexpr double R = 0.02, H = 0.01;
  Press press(make_body({ShapeType::plane, dvec3(0), nullptr, 0}, soft_with(tested.law, H), "half-space"),
              make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0.05 * R}, {}, "ball"));
  Statistic force;
  for (int i = 0; i < kPresses; ++i) {
    const double x = H * (0.1 + 0.8 * CounterRng(16, static_cast<std::uint64_t>(i)).uniform(3));
    press.at(Pose{}, {random_pose(16, i, 0).q, dvec3(0, 0, R - x)});
    force.add(-press.force_W().z, integral_of(std::sqrt(2 * R * x - x * x), [&](double r) {
      return 2 * kPi * r * kModulus * tested.law.pressure((x - R + std::sqrt(R * R - r * r)) / H);
    }));
  }
  const CheckedCase about{"A15", fmt::format("L = {}: the rigid sphere of A2, x/H from 0.1 to 0.9", tested.name)};
  return force.worst(about, "force", "N", 0.01);
}

/// A soft box on a rigid plane: (E/H) L'(z/H) acts on the area (L1 - 2z)(L2 - 2z), z from 0 to x.
ClosedFormCheck press_box_of_law(const NamedLaw& tested) {
  const dvec3 half(0.02, 0.03, 0.015);
  const double H = half.z;
  Press press(make_body({ShapeType::box, half, nullptr, 0}, soft_with(tested.law, 0), "box"), rigid_plane());
  Statistic force;
  for (int i = 0; i < kPresses; ++i) {
    Pose X_WA = random_stand(17, i);
    const double x = H * (0.05 + 0.5 * CounterRng(17, static_cast<std::uint64_t>(i)).uniform(3));
    X_WA.p.z = half.z - x;
    press.at(X_WA, Pose{});
    // By parts, because the derivative of a table jumps.
    const auto area = [&](double z) { return (2 * half.x - 2 * z) * (2 * half.y - 2 * z); };
    const double inside =
        integral_of(x, [&](double z) { return tested.law.pressure(z / H) * 2 * (2 * half.x + 2 * half.y - 4 * z); });
    force.add(press.force_W().z, kModulus * (tested.law.pressure(x / H) * area(x) + inside));
  }
  const CheckedCase about{"A15", fmt::format("L = {}: the box of A4", tested.name)};
  return force.worst(about, "force", "N", 1e-4);
}

/// Two stacked slabs have the pressure p with H e(p/E) + H' e'(p/E') = x, found by bisection.
ClosedFormCheck press_slabs_of_law(const NamedLaw& tested) {
  constexpr double H = 0.006, below = 0.01, stiffer = 3, kTop = 0.02;
  const PressureLaw other{LawKind::stiffening, 0.3, {}};
  Press press(
      make_body({ShapeType::mesh, dvec3(0), std::make_shared<TriMesh>(make_box(dvec3(0.1, 0.1, kTop))), 0},
                soft_with(tested.law, H), "slab"),
      make_body({ShapeType::plane, dvec3(0), nullptr, 0}, soft_with(other, below, stiffer * kModulus), "floor"));
  Statistic peak;
  for (int i = 0; i < kPresses; ++i) {
    Pose X_WA = random_stand(18, i);
    const double x = H * (0.1 + 0.9 * CounterRng(18, static_cast<std::uint64_t>(i)).uniform(3));
    X_WA.p.z = kTop - x;
    press.at(X_WA, Pose{});
    double low = 0, high = 100 * kModulus;
    for (int step = 0; step < 200; ++step) {
      const double p = 0.5 * (low + high);
      (H * tested.law.strain(p / kModulus) + below * other.strain(p / (stiffer * kModulus)) < x ? low : high) = p;
    }
    peak.add(press.surface().max_pressure(), low);
  }
  const CheckedCase about{
      "A15",
      fmt::format("L = {}: a slab of 6 mm on one of 10 mm with e/(1 - 0.3 e), three times as stiff", tested.name)};
  return peak.worst(about, "largest pressure", "Pa", 0.01);
}

}  // namespace

ClosedFormChecks validate_pressure_laws() {
  ClosedFormChecks checks;
  for (const NamedLaw& tested : kTestedLaws) {
    checks.push_back(press_sphere_of_law(tested));
    checks.push_back(press_half_space_of_law(tested));
    checks.push_back(press_box_of_law(tested));
    checks.push_back(press_slabs_of_law(tested));
  }
  return checks;
}

}  // namespace taxel
