#include "core/project/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"

namespace taxel {
namespace {

/// The rotation that turns the unit vector n to +z; n is not -z.
dquat turn_up(const dvec3& n) {
  // half-way quaternion: (1 + n.z, n x z), normalised
  const dvec3 axis = glm::cross(n, dvec3(0, 0, 1));
  return glm::normalize(dquat(1.0 + n.z, axis.x, axis.y, axis.z));
}

/// Directions spread evenly over the sphere: a Fibonacci spiral of n points.
dquat spread_rotation(int i, int n) {
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  const double z = 1.0 - (2.0 * i + 1.0) / n;
  const double r = std::sqrt(1.0 - z * z);
  return turn_up(dvec3(r * std::cos(golden * i), r * std::sin(golden * i), z));
}

/// Relative errors of one quantity over many poses.
class Statistic {
 public:
  explicit Statistic(double exact) : exact_(exact) {}
  void add(double computed) {
    const double error = std::abs(computed - exact_) / std::abs(exact_);
    sum_ += computed;
    error_sum_ += error;
    ++count_;
    if (error >= worst_error_) {
      worst_error_ = error;
      worst_ = computed;
    }
  }
  [[nodiscard]] ClosedFormCheck mean(const ClosedFormCheck& about, double bound) const {
    ClosedFormCheck check = about;
    check.quantity += fmt::format(", mean of {}", count_);
    check.computed = sum_ / count_;
    check.exact = exact_;
    check.error = error_sum_ / count_;
    check.bound = bound;
    return check;
  }
  [[nodiscard]] ClosedFormCheck worst(const ClosedFormCheck& about, double bound) const {
    ClosedFormCheck check = about;
    check.quantity += fmt::format(", worst of {}", count_);
    check.computed = worst_;
    check.exact = exact_;
    check.error = worst_error_;
    check.bound = bound;
    return check;
  }

 private:
  double exact_, sum_ = 0, error_sum_ = 0, worst_ = 0, worst_error_ = 0;
  int count_ = 0;
};

ClosedFormCheck about(const std::string& form, const std::string& setting, const std::string& quantity,
                      const std::string& unit) {
  ClosedFormCheck check;
  check.form = form;
  check.setting = setting;
  check.quantity = quantity;
  check.unit = unit;
  return check;
}

/// The part of a cube below a plane, by inclusion and exclusion of corner simplices: for n with positive components and
/// the plane n.x = t over the cube [0, L]^3,
///   V(t) = sum over corners s in {0, L}^3 of (-1)^|s| (t - n.s)+^3 / (6 nx ny nz),
/// each term the simplex {x >= s, n.x <= t}, whose centroid is s + (t - n.s)/4 (1/nx, 1/ny, 1/nz).
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

}  // namespace

std::vector<ClosedFormCheck> validate_soft_sphere_on_plane() {
  constexpr double R = 0.05, E = 5e4, x = 0.05 * R;
  constexpr int kDirections = 200;
  const HydroBodyPtr sphere =
      make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0.17 * R}, {FieldKind::medial_axis, E, 0, 0, 0}, "sphere");
  const HydroBodyPtr plane = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {}, "plane");
  const std::size_t tets = std::get<SoftBody>(sphere->geometry).field->tets().size();
  Statistic force(kPi * E * x * x * (1 - 2 * x / (3 * R)));
  Statistic area(kPi * (2 * R * x - x * x));
  Statistic peak(E * x / R);
  ContactSurface surface;
  IntersectWorkspace workspace;
  for (int i = 0; i < kDirections; ++i) {
    const Pose X_WA{spread_rotation(i, kDirections), dvec3(0, 0, R - x)};
    intersect(*sphere, *plane, X_WA, Pose{}, surface, workspace);
    force.add(X_WA.rotate(pressure_wrench(surface).force).z);
    area.add(surface.area());
    peak.add(surface.max_pressure());
  }
  const std::string setting =
      fmt::format("soft sphere of {} tets on a rigid plane, R = {} m, E = {} Pa, x/R = {:g}", tets, R, E, x / R);
  return {force.mean(about("A1", setting, "force", "N"), 0.01), force.worst(about("A1", setting, "force", "N"), 0.03),
          area.mean(about("A1", setting, "area", "m^2"), 0.02),
          peak.mean(about("A1", setting, "largest pressure", "Pa"), 0.03)};
}

std::vector<ClosedFormCheck> validate_sphere_in_half_space() {
  constexpr double R = 0.02, E = 5e4, H = 0.05, x = 0.25 * R;
  constexpr double kappa = E / H;
  constexpr int kDirections = 50;
  const HydroBodyPtr sphere = make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0.1 * R}, {}, "sphere");
  const HydroBodyPtr ground =
      make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {FieldKind::medial_axis, E, H, 0, 0}, "half-space");
  Statistic force(kappa * kPi * x * x * (R - x / 3));
  Statistic area(2 * kPi * R * x);
  ContactSurface surface;
  IntersectWorkspace workspace;
  for (int i = 0; i < kDirections; ++i) {
    const Pose X_WA{spread_rotation(i, kDirections), dvec3(0, 0, R - x)};
    intersect(*sphere, *ground, X_WA, Pose{}, surface, workspace);
    force.add(X_WA.rotate(pressure_wrench(surface).force).z);
    area.add(surface.area());
  }
  const std::string setting =
      fmt::format("rigid sphere in a soft half-space, R = {} m, E/H = {} Pa/m, x/R = {:g}", R, kappa, x / R);
  return {force.worst(about("A2", setting, "force", "N"), 0.01), area.worst(about("A2", setting, "area", "m^2"), 0.02)};
}

std::vector<ClosedFormCheck> validate_polyhedron_in_half_space() {
  constexpr double L = 0.04, E = 5e4, H = 0.1;
  constexpr double kappa = E / H;
  const HydroBodyPtr cube = make_body({ShapeType::box, dvec3(L / 2), nullptr, 0}, {}, "cube");
  const HydroBodyPtr ground =
      make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {FieldKind::medial_axis, E, H, 0, 0}, "half-space");
  Statistic force(1.0), line(1.0);  // ratios to the exact values of each pose
  ContactSurface surface;
  IntersectWorkspace workspace;
  const dvec3 half(L / 2);
  for (const dvec3& direction : {dvec3(1, 1, 1), dvec3(1, 2, 5), dvec3(3, 2, 0.3), dvec3(0.2, 7, 1)}) {
    const dvec3 n = glm::normalize(direction);  // points up, in the cube's frame
    const double tallest = L * (n.x + n.y + n.z);
    for (const double part : {0.1, 0.35, 0.6, 0.95}) {
      const double t = part * tallest;
      const Part below = cube_below_plane(L, n, t);
      // the cube's frame turned so that n points up; its corner at -half lies t below the half-space's surface
      const Pose X_WA{turn_up(n), dvec3(0, 0, glm::dot(n, half) - t)};
      intersect(*cube, *ground, X_WA, Pose{}, surface, workspace);
      const Wrench wrench = pressure_wrench(surface);
      const dvec3 exact_force = kappa * below.volume * n;
      const dvec3 exact_torque = glm::cross(below.centroid - half, exact_force);
      force.add(1.0 + glm::length(wrench.force - exact_force) / glm::length(exact_force));
      line.add(1.0 + glm::length(wrench.torque - exact_torque) / (L * glm::length(exact_force)));
    }
  }
  const std::string setting = fmt::format("rigid cube in a soft half-space, edge {} m, E/H = {} Pa/m", L, kappa);
  return {force.worst(about("A3", setting, "force over kappa V", "1"), 1e-10),
          line.worst(about("A3", setting, "torque over (kappa V) x lever", "1"), 1e-10)};
}

std::vector<ClosedFormCheck> validate_all() {
  std::vector<ClosedFormCheck> all;
  for (const auto& checks :
       {validate_soft_sphere_on_plane(), validate_sphere_in_half_space(), validate_polyhedron_in_half_space()}) {
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

}  // namespace taxel
