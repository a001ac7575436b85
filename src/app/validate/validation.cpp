// Static contact, A1 to A8: soft primitives on a rigid plane, rigid bodies in a soft half-space, two soft bodies.
#include "app/validate/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/validate/setups.h"

namespace taxel {

ClosedFormCheck CheckedCase::limit(const std::string& quantity, const std::string& unit, double computed,
                                   Relation relation, double limit) const {
  const double excess = relation == Relation::at_most ? computed - limit : limit - computed;
  // This comparison lets a computed NaN become a NaN error, which fails.
  const double error = excess <= 0 ? 0 : excess / std::abs(limit);
  return {form, setting, quantity, unit, computed, limit, error, 0, relation};
}

void Statistic::add(double computed, double exact) {
  const double error = std::abs(computed - exact) / std::abs(exact);
  computed_sum_ += computed;
  exact_sum_ += exact;
  error_sum_ += error;
  ++count_;
  constexpr double kRounding = 1e-12;  // the first of nearly equal errors wins, on every machine
  const bool worse = !std::isnan(worst_error_) && !(error < worst_error_ + kRounding);  // a NaN remains the worst
  if (count_ == 1 || worse) {
    worst_error_ = error;
    worst_computed_ = computed;
    worst_exact_ = exact;
  }
}

ClosedFormCheck Statistic::mean(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                double bound) const {
  return {about.form,
          about.setting,
          fmt::format("{}, mean of {}", quantity, count_),
          unit,
          computed_sum_ / count_,
          exact_sum_ / count_,
          mean_error(),
          bound,
          Relation::equal};
}

ClosedFormCheck Statistic::worst(const CheckedCase& about, const std::string& quantity, const std::string& unit,
                                 double bound) const {
  return {about.form,   about.setting,   fmt::format("{}, worst of {}", quantity, count_),
          unit,         worst_computed_, worst_exact_,
          worst_error_, bound,           Relation::equal};
}

namespace {

/// Errors of one soft sphere over many directions.
struct SphereErrors {
  std::size_t tets = 0;
  Statistic force, area, peak, rim;
};

/// A1. The plane cuts the sphere in the disc rho <= a, a^2 = R^2 - h^2, h = R - x, where p = E (1 - sqrt(rho^2 +
/// h^2)/R): F = integral of 2 pi rho p over the disc = pi E (R^2 - h^2 - 2 (R^3 - h^3)/(3R)) = pi E x^2 (1 - 2x/(3R)).
SphereErrors press_soft_sphere(double resolution, int directions) {
  constexpr double R = 0.05, E = 5e4, x = 0.05 * R;
  const HydroBodyPtr sphere = soft_primitive(ShapeType::sphere, dvec3(R, 0, 0), E, resolution * R);
  Press press(sphere, rigid_plane());
  SphereErrors errors;
  errors.tets = tet_count(*sphere);
  for (int i = 0; i < directions; ++i) {
    const Pose X_WA{random_pose(1, i, 0).q, dvec3(0, 0, R - x)};
    press.at(X_WA, Pose{});
    errors.force.add(press.force_W().z, kPi * E * x * x * (1 - 2 * x / (3 * R)));
    errors.area.add(press.surface().area(), kPi * (2 * R * x - x * x));
    errors.peak.add(press.surface().max_pressure(), E * x / R);
    errors.rim.add(press.rim_radius(dvec3(0), X_WA.inverse().rotate(dvec3(0, 0, 1))), std::sqrt(2 * R * x - x * x));
  }
  return errors;
}

}  // namespace

ClosedFormChecks validate_soft_sphere_on_plane() {
  constexpr int kDirections = 200;
  constexpr std::array<double, 3> kResolutions{0.17, 0.085, 0.0425};  // edge length over radius: h, h/2, h/4
  std::array<SphereErrors, 3> errors;
  for (std::size_t i = 0; i < 3; ++i) errors[i] = press_soft_sphere(kResolutions[i], kDirections);
  const CheckedCase about{"A1", fmt::format("soft sphere of {} tets on a rigid plane, R = 0.05 m, E = 50000 Pa, x/R = "
                                            "0.05, random orientations",
                                            errors[0].tets)};
  ClosedFormChecks checks{
      errors[0].force.mean(about, "force", "N", 0.01), errors[0].force.worst(about, "force", "N", 0.03),
      errors[0].area.mean(about, "area", "m^2", 0.02), errors[0].rim.mean(about, "rim radius", "m", 0.01),
      errors[0].peak.mean(about, "largest pressure", "Pa", 0.03)};
  const CheckedCase finer{"A1", "the same with edges of half and a quarter the length"};
  for (std::size_t i = 1; i < 3; ++i) {
    // The order is the power of the edge length with which the mean error falls.
    const double order = std::log2(errors[i - 1].force.mean_error() / errors[i].force.mean_error());
    checks.push_back(errors[i].force.mean(finer, fmt::format("force, {} tets", errors[i].tets), "N", 0.01));
    checks.push_back(finer.limit(fmt::format("order of the error, {} to {} tets", errors[i - 1].tets, errors[i].tets),
                                 "1", order, Relation::at_least, 1.9));
  }
  return checks;
}

/// A4. At the depth x the plane cuts the box in L1 x L2; p = (E/H) min(x, s) with the distance s to the nearest side.
/// F = (E/H) times the integral of the area (L1 - 2z)(L2 - 2z) over z from 0 to x.
ClosedFormChecks validate_soft_box_on_plane() {
  constexpr double E = 5e4;
  constexpr int kPoses = 50;
  const dvec3 half(0.02, 0.03, 0.015);
  const double H = half.z, L1 = 2 * half.x, L2 = 2 * half.y;
  Press press(soft_primitive(ShapeType::box, half, E, 0), rigid_plane());
  Statistic force, area;
  for (int i = 0; i < kPoses; ++i) {
    Pose X_WA = random_stand(4, i);
    const double x = H * (0.05 + 0.5 * CounterRng(4, static_cast<std::uint64_t>(i)).uniform(3));
    X_WA.p.z = half.z - x;
    press.at(X_WA, Pose{});
    force.add(press.force_W().z, E / H * (x * L1 * L2 - x * x * (L1 + L2) + 4 * x * x * x / 3));
    area.add(press.surface().area(), L1 * L2);
  }
  const CheckedCase about{
      "A4", fmt::format("soft box of {} x {} x {} m on a rigid plane, E = {} Pa, x/H from 0.05 to 0.55, random places",
                        L1, L2, 2 * half.z, E)};
  return {force.worst(about, "force", "N", 1e-10), area.worst(about, "area", "m^2", 1e-10)};
}

/// A5. p = (E/H) min(x, R - rho), H = R: F = integral of 2 pi rho p = pi E (R^3 - (R - x)^3)/(3H).
ClosedFormChecks validate_standing_cylinder() {
  constexpr double E = 5e4, R = 0.02, half = 0.03, x = 0.1 * R;
  constexpr int kPoses = 50;
  const HydroBodyPtr cylinder = soft_primitive(ShapeType::cylinder, {R, half, 0}, E, 0.1 * R);
  Press press(cylinder, rigid_plane());
  Statistic force, area;
  for (int i = 0; i < kPoses; ++i) {
    Pose X_WA = random_stand(5, i);
    X_WA.p.z = half - x;
    press.at(X_WA, Pose{});
    force.add(press.force_W().z, kPi * E * (R * R * R - (R - x) * (R - x) * (R - x)) / (3 * R));
    area.add(press.surface().area(), kPi * R * R);
  }
  const CheckedCase about{"A5", fmt::format("soft cylinder of {} tets standing on a rigid plane, R = {} m, half length "
                                            "{} m, E = {} Pa, x/R = {:g}, random places",
                                            tet_count(*cylinder), R, half, E, x / R)};
  return {force.worst(about, "force", "N", 0.01), area.worst(about, "area", "m^2", 0.02)};
}

/// A6. Per length, with p = E (1 - sqrt(y^2 + h^2)/R) for |y| <= a: F = E (2a - (a R + h^2 asinh(a/h))/R).
ClosedFormChecks validate_lying_cylinder() {
  constexpr double E = 5e4, R = 0.02, x = 0.1 * R, h = R - x, kLong = 0.06, kShort = 0.04;
  constexpr int kPoses = 50;
  const double a = std::sqrt(R * R - h * h), exact = E * (a - h * h / R * std::asinh(a / h));
  const HydroBodyPtr long_one = soft_primitive(ShapeType::cylinder, {R, kLong, 0}, E, 0.1 * R);
  Press long_press(long_one, rigid_plane());
  Press short_press(soft_primitive(ShapeType::cylinder, {R, kShort, 0}, E, 0.1 * R), rigid_plane());
  Statistic force, area;
  for (int i = 0; i < kPoses; ++i) {
    Pose X_WA = random_stand(6, i);
    const double roll = 2 * kPi * CounterRng(6, static_cast<std::uint64_t>(i)).uniform(3);
    X_WA.q = X_WA.q * glm::angleAxis(kPi / 2, dvec3(1, 0, 0)) * glm::angleAxis(roll, dvec3(0, 0, 1));
    X_WA.p.z = h;
    long_press.at(X_WA, Pose{});
    short_press.at(X_WA, Pose{});
    // Both cylinders have the same ends, so the difference of the forces is that of a piece without ends.
    force.add((long_press.force_W().z - short_press.force_W().z) / (2 * (kLong - kShort)), exact);
    area.add((long_press.surface().area() - short_press.surface().area()) / (2 * (kLong - kShort)), 2 * a);
  }
  const CheckedCase about{"A6", fmt::format("soft cylinder lying on a rigid plane, difference of the lengths {} and {} "
                                            "m, R = {} m, E = {} Pa, x/R = {:g}, random rolls",
                                            2 * kLong, 2 * kShort, R, E, x / R)};
  return {force.mean(about, "force per length", "N/m", 0.01), force.worst(about, "force per length", "N/m", 0.03),
          area.mean(about, "area per length", "m", 0.02)};
}

// Rigid bodies in a soft half-space: A2, A3.

namespace {

/// Returns the part of a cube below a plane, by inclusion and exclusion of corner simplices. For n with positive
/// components and the plane n.x = t over the cube [0, L]^3,
///   V(t) = sum over corners s in {0, L}^3 of (-1)^|s| (t - n.s)+^3 / (6 nx ny nz),
/// in which each term is the simplex {x >= s, n.x <= t} with the centroid s + (t - n.s)/4 (1/nx, 1/ny, 1/nz).
struct Part {
  double volume = 0;
  dvec3 centroid{0};
};
Part cube_below_plane(double edge, const dvec3& n, double t) {
  Part part;
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 bits(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    const dvec3 s = edge * bits;
    const double height = t - glm::dot(n, s);
    if (height <= 0) continue;
    const double sign = static_cast<int>(bits.x + bits.y + bits.z) % 2 == 0 ? 1.0 : -1.0;
    const double volume = sign * height * height * height / (6.0 * n.x * n.y * n.z);
    part.volume += volume;
    part.centroid += volume * (s + 0.25 * height / n);
  }
  part.centroid /= part.volume;
  return part;
}

/// Returns a unit vector with components above 0.1, because the sum over corners loses digits if one of them is small.
dvec3 random_upward(const CounterRng& rng) {
  return glm::normalize(dvec3(0.1) + dvec3(rng.uniform(0), rng.uniform(1), rng.uniform(2)));
}

}  // namespace

/// A2. The sphere's skin at the depth z below the surface, 0 <= z <= x, has the area 2 pi R dz and its normal's
/// vertical part is (R - x + z)/R: F = integral of kappa z 2 pi (R - x + z) dz = kappa pi x^2 (R - x/3).
ClosedFormChecks validate_sphere_in_half_space() {
  constexpr double R = 0.02, E = 5e4, H = 0.05, kappa = E / H, x = 0.25 * R;
  constexpr int kPoses = 200;
  Press press(make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0.1 * R}, {}, "sphere"), soft_plane(E, H));
  Statistic force, area;
  for (int i = 0; i < kPoses; ++i) {
    Pose X_WA = random_pose(2, i, 0.5);
    X_WA.p.z = R - x;
    press.at(X_WA, Pose{});
    force.add(press.force_W().z, kappa * kPi * x * x * (R - x / 3));
    area.add(press.surface().area(), 2 * kPi * R * x);
  }
  const CheckedCase about{
      "A2", fmt::format("rigid sphere in a soft half-space, R = {} m, E/H = {} Pa/m, x/R = {:g}, random poses", R,
                        kappa, x / R)};
  return {force.worst(about, "force", "N", 0.01), area.worst(about, "area", "m^2", 0.02)};
}

ClosedFormChecks validate_polyhedron_in_half_space() {
  constexpr double L = 0.04, E = 5e4, H = 0.1, kappa = E / H;
  constexpr int kPoses = 200;
  const dvec3 half(L / 2);
  Press press(make_body({ShapeType::box, half, nullptr, 0}, {}, "cube"), soft_plane(E, H, FaceRule::all));
  Statistic force, line;  // ratios to the exact values of each pose
  for (int i = 0; i < kPoses; ++i) {
    const CounterRng rng(3, static_cast<std::uint64_t>(i));
    const dvec3 n = random_upward(rng);  // the upward direction in the cube's frame
    const double t = (0.1 + 0.85 * rng.uniform(3)) * L * (n.x + n.y + n.z);
    const Part below = cube_below_plane(L, n, t);
    // The cube's frame is rotated so that n points up. The corner at -half is t below the half-space's surface.
    Pose X_WA = random_stand(3, i);
    X_WA.q = X_WA.q * turn_up(n);
    X_WA.p.z = glm::dot(n, half) - t;
    press.at(X_WA, Pose{});
    const Wrench wrench = press.wrench_A();
    const dvec3 exact_force = kappa * below.volume * n;
    const dvec3 exact_torque = glm::cross(below.centroid - half, exact_force);
    force.add(1.0 + glm::length(wrench.force - exact_force) / glm::length(exact_force), 1);
    line.add(1.0 + glm::length(wrench.torque - exact_torque) / (L * glm::length(exact_force)), 1);
  }
  const CheckedCase about{
      "A3", fmt::format("rigid cube in a soft half-space, edge {} m, E/H = {} Pa/m, random poses", L, kappa)};
  return {force.worst(about, "force over kappa V", "1", 1e-10),
          line.worst(about, "torque over (kappa V) x lever", "1", 1e-10)};
}

// Two soft bodies: A7, A8. The surface is where their pressures are equal.

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

ClosedFormChecks validate_statics() {
  ClosedFormChecks all;
  for (const auto& validate :
       {validate_soft_sphere_on_plane, validate_sphere_in_half_space, validate_polyhedron_in_half_space,
        validate_soft_box_on_plane, validate_standing_cylinder, validate_lying_cylinder, validate_two_soft_spheres,
        validate_stacked_slabs, validate_pressure_laws, validate_samples, validate_geodesics, validate_weighted_mean}) {
    const ClosedFormChecks checks = validate();
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

}  // namespace taxel
