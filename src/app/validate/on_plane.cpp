// Soft primitives on a rigid plane: A1, A4, A5, A6.
#include <fmt/format.h>

#include <array>

#include "app/validate/press.h"
#include "app/validate/validation.h"

namespace taxel {
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

}  // namespace taxel
