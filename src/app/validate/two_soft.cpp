// Two soft bodies: A7, A8. The surface is where their pressures are equal.
#include <fmt/format.h>

#include "app/validate/press.h"
#include "app/validate/validation.h"

namespace taxel {

/// A7. A's centre at the origin, B's at (0, 0, D). On the circle (rho, z), pA = EA (1 - rA/RA) and pB = EB (1 - rB/RB).
/// At given rho the surface lies where pA(z) - pB(z) changes sign. The vertical part of its normal times its area is
/// the plane's 2 pi rho d rho, so F = integral of 2 pi rho p; the area has another 1/nz, n along the gradient of pA -
/// pB.
TwoSpheresContact two_spheres_contact(const TwoSpheres& s) {
  const double kA = s.modulus_A / s.radius_A, kB = s.modulus_B / s.radius_B;
  const double D = s.radius_A + s.radius_B - s.depth;
  TwoSpheresContact contact;
  contact.axis_pressure = s.depth * kA * kB / (kA + kB);
  const double to_rim = (D * D + s.radius_A * s.radius_A - s.radius_B * s.radius_B) / (2 * D);  // along the axis
  contact.rim_radius = std::sqrt(s.radius_A * s.radius_A - to_rim * to_rim);
  const auto height = [&](double rho) {
    double low = 0, high = D;
    for (int i = 0; i < 100; ++i) {
      const double z = 0.5 * (low + high);
      const double difference = kA * (s.radius_A - std::hypot(rho, z)) - kB * (s.radius_B - std::hypot(rho, D - z));
      (difference > 0 ? low : high) = z;  // pA falls along z, pB rises
    }
    return 0.5 * (low + high);
  };
  constexpr int kIntervals = 1000;  // Simpson's rule
  for (int i = 0; i <= kIntervals; ++i) {
    const double rho = contact.rim_radius * i / kIntervals, z = height(rho);
    const double rA = std::hypot(rho, z), rB = std::hypot(rho, D - z);
    const dvec2 gradient = -kA / rA * dvec2(rho, z) + kB / rB * dvec2(rho, z - D);  // of pA - pB, (rho, z)
    const double weight = (i == 0 || i == kIntervals ? 1 : i % 2 == 1 ? 4 : 2) * contact.rim_radius / (3 * kIntervals);
    contact.force += weight * 2 * kPi * rho * kA * (s.radius_A - rA);
    contact.area += weight * 2 * kPi * rho * glm::length(gradient) / std::abs(gradient.y);
  }
  return contact;
}

ClosedFormChecks validate_two_soft_spheres() {
  constexpr int kPoses = 100;
  const TwoSpheres s{0.05, 1e5, 0.05, 4e5, 0.004};
  const TwoSpheresContact exact = two_spheres_contact(s);
  const HydroBodyPtr a = soft_primitive(ShapeType::sphere, dvec3(s.radius_A, 0, 0), s.modulus_A, 0.17 * s.radius_A);
  Press press(a, soft_primitive(ShapeType::sphere, dvec3(s.radius_B, 0, 0), s.modulus_B, 0.17 * s.radius_B));
  Statistic force, area, rim, peak;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WA = random_pose(7, i, 0.5);
    const dvec3 axis_W = random_pose(8, i, 0).rotate(dvec3(0, 0, 1));  // from A to B
    const Pose X_WB{random_pose(9, i, 0).q, X_WA.p + (s.radius_A + s.radius_B - s.depth) * axis_W};
    press.at(X_WA, X_WB);
    force.add(-glm::dot(press.force_W(), axis_W), exact.force);
    area.add(press.surface().area(), exact.area);
    rim.add(press.rim_radius(dvec3(0), X_WA.inverse().rotate(axis_W)), exact.rim_radius);
    peak.add(press.surface().max_pressure(), exact.axis_pressure);
  }
  const CheckedCase about{"A7",
                          fmt::format("two soft spheres of {} tets, R = {} m both, E = {:g} and {:g} Pa, x = {} m, "
                                      "random poses",
                                      tet_count(*a), s.radius_A, s.modulus_A, s.modulus_B, s.depth)};
  return {force.mean(about, "force", "N", 0.01), force.worst(about, "force", "N", 0.03),
          area.mean(about, "area", "m^2", 0.02), rim.mean(about, "rim radius", "m", 0.01),
          peak.mean(about, "largest pressure", "Pa", 0.03)};
}

namespace {

/// Returns the force of a soft box on a soft slab that is pressed only from above, pB = kB (depth below its top). Over
/// a point of the box's lower face at the distance s from its nearest side, pA = kA min(s, z), z the height above that
/// face, and the slab's depth there is x - z. Pressures are equal at z = x kB/(kA + kB), or, nearer to the side, where
/// pB = kA s: so p = kA min(s, z*), as if the box stood on a rigid plane at the depth z* = x kB/(kA + kB), and A4 gives
/// the force; on the plateau p = kA z* = x/(1/kA + 1/kB).
double stacked_force(double stiffness_A, double stiffness_B, double L1, double L2, double x) {
  const double z = x * stiffness_B / (stiffness_A + stiffness_B);
  return stiffness_A * (z * L1 * L2 - z * z * (L1 + L2) + 4 * z * z * z / 3);
}

struct Stack {
  const char* setting;
  HydroBodyPtr slab;
  double stiffness, top, bound;
};

}  // namespace

ClosedFormChecks validate_stacked_slabs() {
  constexpr double EA = 1e5, EB = 3e5, HB = 0.03, x = 0.004;
  constexpr int kPoses = 50;
  const dvec3 half(0.02, 0.03, 0.015);
  const double kA = EA / half.z, L1 = 2 * half.x, L2 = 2 * half.y;
  const HydroBodyPtr box = soft_primitive(ShapeType::box, half, EA, 0);
  const Stack stacks[] = {
      {"soft box on a wider soft box", soft_primitive(ShapeType::box, {0.2, 0.25, HB}, EB, 0), EB / HB, HB, 1e-10},
      {"soft box on a soft half-space", soft_plane(EB, HB), EB / HB, 0, 1e-10}};
  ClosedFormChecks checks;
  for (const Stack& stack : stacks) {
    Press press(box, stack.slab);
    Statistic force, peak;
    for (int i = 0; i < kPoses; ++i) {
      Pose X_WA = random_stand(10, i);
      X_WA.p *= 0.1;
      X_WA.p.z = stack.top + half.z - x;
      press.at(X_WA, Pose{});
      force.add(press.force_W().z, stacked_force(kA, stack.stiffness, L1, L2, x));
      peak.add(press.surface().max_pressure(), x / (1 / kA + 1 / stack.stiffness));
    }
    const CheckedCase about{"A8", fmt::format("{}, E/H = {:g} and {:g} Pa/m, x = {} m, random places", stack.setting,
                                              kA, stack.stiffness, x)};
    checks.push_back(force.worst(about, "force", "N", stack.bound));
    checks.push_back(peak.worst(about, "pressure", "Pa", stack.bound));
  }
  // For EB -> infinity the slab becomes a rigid plane, as in A4.
  Press on_stiff(box, soft_plane(1e6 * EA, half.z)), on_rigid(box, rigid_plane());
  Statistic force;
  for (int i = 0; i < kPoses; ++i) {
    Pose X_WA = random_stand(11, i);
    X_WA.p.z = half.z - x;
    on_stiff.at(X_WA, Pose{});
    on_rigid.at(X_WA, Pose{});
    force.add(on_stiff.force_W().z, on_rigid.force_W().z);
  }
  checks.push_back(force.worst({"A8", "soft box on a half-space a million times as stiff, against a rigid plane"},
                               "force", "N", 2e-6));
  return checks;
}

}  // namespace taxel
