// Rigid bodies in a soft half-space: A2, A3.
#include <fmt/format.h>

#include "app/validate/press.h"
#include "app/validate/validation.h"

namespace taxel {
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

}  // namespace taxel
