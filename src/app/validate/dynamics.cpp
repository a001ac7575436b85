// The motion of bodies, A9, and rolling, spinning and impact, A11 to A14.
#include "app/validate/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/validate/setups.h"
#include "core/hydro/traction.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

SoftOnFloor coarse_ball(const std::string& integrator, double dissipation) {
  return soft_ball(integrator, dissipation, 0.17 * kBallRadius);
}

}  // namespace

ClosedFormChecks validate_rest_depth() {
  const double exact = ball_rest_depth();
  Statistic depth;
  double residual = 0;
  for (const char* integrator : kIntegrators) {
    SoftOnFloor setup = coarse_ball(integrator, 20);
    setup.start = kBallRadius + 0.005;
    SoftOnFloorRun run(setup);
    run.step(1000);
    depth.add(kBallRadius - run.height(), exact);
    residual = std::max(residual, glm::length(run.velocity()));
  }
  const CheckedCase about{"A9",
                          fmt::format("soft ball dropped onto a rigid plane, R = {} m, E = {} Pa, m = {} kg, d = 20 "
                                      "s/m, steps of 2 ms, every integrator",
                                      kBallRadius, kBallModulus, kBallMass)};
  return {depth.worst(about, "depth at rest", "m", 0.01),
          about.limit("speed at rest", "m/s", residual, Relation::at_most, 1e-6)};
}

/// Every point of the ball has the same normal speed v (inward positive), so F = f(x) (1 + d v) and m v dv/dx = -f (1 +
/// d v): the integral of v dv/(1 + d v), G(v) = v/d - ln(1 + d v)/d^2, falls by the integral of f/m on the way in and
/// grows by it on the way out: G(-rebound) = G(impact), whatever f is. 1 - d rebound > 0 bounds the rebound by 1/d.
ClosedFormChecks validate_rebound() {
  constexpr double impact = 1.0;
  const CheckedCase about{
      "A9",
      fmt::format("the ball thrown at the plane with {} m/s, no gravity, steps of 2 ms, every integrator", impact)};
  ClosedFormChecks checks;
  for (const double d : {0.5, 1.0, 5.0}) {
    const auto G = [d](double v) { return v / d - std::log1p(d * v) / (d * d); };
    const double exact = root([&](double v) { return G(-v) - G(impact); }, 0, (1 - 1e-15) / d);
    Statistic speed;
    double fastest = 0;
    for (const char* integrator : kIntegrators) {
      SoftOnFloor setup = coarse_ball(integrator, d);
      setup.start = 1.05 * kBallRadius;
      setup.gravity = dvec3(0);
      setup.timestep = 0.002;
      SoftOnFloorRun run(setup);
      run.set_velocity({0, 0, -impact});
      run.step(1000);
      speed.add(run.velocity().z, exact);
      fastest = std::max(fastest, run.velocity().z);
    }
    checks.push_back(speed.worst(about, fmt::format("rebound, d = {} s/m", d), "m/s", 0.01));
    checks.push_back(
        about.limit(fmt::format("rebound against 1/d, d = {} s/m", d), "m/s", fastest, Relation::at_most, 1 / d));
  }
  return checks;
}

ClosedFormChecks validate_energy() {
  double largest = 0;
  int flights = 0;
  for (const char* integrator : kIntegrators) {
    SoftOnFloor setup = coarse_ball(integrator, 0.5);
    setup.start = 0.05;
    setup.timestep = 5e-4;
    SoftOnFloorRun run(setup);
    run.set_velocity({0.3, 0, 0});
    double before = run.energy();
    bool was_touching = false;
    for (int n = 0; n < 2000; ++n) {
      const double now = run.energy();
      run.step();
      if (!run.touching()) {  // in flight the skin stores no energy
        largest = std::max(largest, now / before);
        before = now;
        flights += was_touching ? 1 : 0;
      }
      was_touching = run.touching();
    }
  }
  const CheckedCase about{"A9", "the ball bouncing and sliding, d = 0.5 s/m, steps of 0.5 ms, every integrator"};
  // In flight the integrators preserve the energy up to rounding.
  return {about.limit("energy over that of the flight before", "1", largest, Relation::at_most, 1 + 1e-9),
          about.limit("bounces", "1", flights, Relation::at_least, 8)};
}

SoftOnFloor block_on_slope(const char* integrator, double theta) {
  constexpr double E = 2e4, H = 0.005, mass = 0.1;
  const dvec3 half(0.03, 0.03, 0.015);
  SoftOnFloor setup;
  setup.skin = std::make_shared<const TriMesh>(make_box(half));
  setup.material = {FieldKind::pad, E, H, 20, 0.5};
  setup.mass = mass;
  setup.center = -0.014;  // near the floor, so that friction does not tip the block
  setup.start = half.z - mass * kGravity * std::cos(theta) / (4 * half.x * half.y * E / H);
  setup.gravity = kGravity * dvec3(std::sin(theta), 0, -std::cos(theta));
  setup.integrator = integrator;
  return setup;
}

ClosedFormChecks validate_slope() {
  constexpr double mu = 0.5, degree = kPi / 180;
  const CheckedCase about{"A9", "soft block on a rigid slope, mu = 0.5, steps of 2 ms, every integrator"};
  ClosedFormChecks checks;
  for (const int angle : {5, 15, 20, 25}) {
    const double exact = kSlipSpeed * std::tan(kPi * std::tan(angle * degree) / (2 * mu));
    Statistic creep;
    for (const char* integrator : kIntegrators) {
      SoftOnFloorRun run(block_on_slope(integrator, angle * degree));
      run.step(400);
      for (int n = 0; n < 20; ++n) {  // the creep is steady in every step
        run.step();
        creep.add(run.velocity().x, exact);
      }
    }
    checks.push_back(creep.worst(about, fmt::format("creep at {} degrees", angle), "m/s", 0.01));
  }
  for (const int angle : {30, 35, 45}) {
    Statistic acceleration;
    for (const char* integrator : kIntegrators) {
      SoftOnFloorRun run(block_on_slope(integrator, angle * degree));
      run.step(300);
      const double before = run.velocity().x;
      run.step(200);
      acceleration.add((run.velocity().x - before) / 0.4,
                       kGravity * (std::sin(angle * degree) - mu * std::cos(angle * degree)));
    }
    checks.push_back(acceleration.worst(about, fmt::format("acceleration at {} degrees", angle), "m/s^2", 0.01));
  }
  return checks;
}

ClosedFormChecks validate_dynamics() {
  ClosedFormChecks all;
  for (const auto& validate : {validate_rest_depth, validate_rebound, validate_energy, validate_slope}) {
    const ClosedFormChecks checks = validate();
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

namespace {

SoftOnFloor fine_ball(const std::string& integrator, double dissipation) {
  SoftOnFloor setup = soft_ball(integrator, dissipation, 0.08 * kBallRadius);
  setup.timestep = 5e-4;
  return setup;
}

/// Returns the integral of a smooth function from a to b by the midpoint rule.
template <class Function>
double integral(const Function& f, double a, double b, int parts = 2000) {
  double sum = 0;
  for (int i = 0; i < parts; ++i) sum += f(a + (b - a) * (i + 0.5) / parts);
  return sum * (b - a) / parts;
}

/// Elastic energy at the depth x, the integral of the force [J].
double ball_energy(double x) {
  return kPi * kBallModulus * x * x * x * (1.0 / 3 - x / (6 * kBallRadius));
}

}  // namespace

ClosedFormChecks validate_rolling() {
  const double exact = kBallRadius - ball_rest_depth();
  Statistic lever;
  for (const char* integrator : kIntegrators) {
    SoftOnFloor setup = fine_ball(integrator, 0);
    setup.start = exact;
    SoftOnFloorRun run(setup);
    run.set_spin({0, 10, 0});
    run.step(400);
    for (int n = 0; n < 200; ++n) {
      run.step();
      lever.add(run.velocity().x / run.spin_W().y, exact);
    }
  }
  const CheckedCase about{"A11",
                          fmt::format("soft ball, R = {} m, E = {} Pa, m = {} kg, spun with 10 rad/s on a rigid plane, "
                                      "mu = 0.5, after 0.2 s, every integrator",
                                      kBallRadius, kBallModulus, kBallMass)};
  return {lever.worst(about, "speed over rate of turning", "m", 1e-3)};
}

ClosedFormChecks validate_spinning() {
  constexpr double R = 0.01, E = 5e4, H = 0.02, mu = 0.5, rate = 50;
  constexpr int kPoses = 20;
  Press press(make_body({ShapeType::cylinder, dvec3(R, 0.01, 0), nullptr, 0.02 * R}, {}, "disc"), soft_plane(E, H));
  Statistic torque;
  for (int i = 0; i < kPoses; ++i) {
    const double x = R * (0.02 + 0.28 * i / (kPoses - 1)), p = E / H * x;
    Pose X_WA = random_stand(12, i);
    X_WA.p.z = 0.01 - x;
    press.at(X_WA, Pose{});
    const Traction spun = traction(press.surface(), {0, mu}, {dvec3(0), dvec3(0, 0, rate)});
    // (2/pi) atan(w r/vs) of the full friction, which matters near the axis
    const auto share = [](double r) { return 2 / kPi * std::atan(rate * r / kSlipSpeed); };
    const double base = 2 * kPi * mu * p * integral([&](double r) { return share(r) * r * r; }, 0, R);
    const double wall = kPi * mu * p * x * R * R * share(R);
    torque.add(-spun.wrench.torque.z, base + wall);
  }
  const CheckedCase about{"A12", fmt::format("rigid disc, R = {} m, spinning with {} rad/s in a soft half-space, E/H = "
                                             "{} Pa/m, mu = {}, x/R from 0.02 to 0.3",
                                             R, rate, E / H, mu)};
  return {torque.worst(about, "friction torque", "N m", 1e-5)};
}

ClosedFormChecks validate_rolling_resistance() {
  constexpr double d = 2, start = 5, seconds = 0.3;
  const double x = ball_rest_depth(), lever = kBallRadius - x,
               rim = std::sqrt(kBallRadius * kBallRadius - lever * lever);
  const auto pressure = [&](double r) { return kBallModulus * (1 - std::hypot(lever, r) / kBallRadius); };
  const double J = kPi * integral([&](double r) { return pressure(r) * r * r * r; }, 0, rim);
  const double inertia = 0.4 * kBallMass * kBallRadius * kBallRadius + kBallMass * lever * lever;
  const double exact = std::exp(-d * J / inertia * seconds);
  Statistic left;
  for (const char* integrator : kIntegrators) {
    SoftOnFloor setup = fine_ball(integrator, d);
    setup.start = lever;
    SoftOnFloorRun run(setup);
    run.set_velocity({start * lever, 0, 0});
    run.set_spin({0, start, 0});
    run.step(100);  // settles
    const double before = run.spin_W().y;
    run.step(static_cast<int>(seconds / setup.timestep));
    left.add(run.spin_W().y / before, exact);
  }
  const CheckedCase about{
      "A13",
      fmt::format("the ball of A11 rolling with {} rad/s, d = {} s/m, over {} s, every integrator", start, d, seconds)};
  return {left.worst(about, "rate of turning that is left", "1", 1e-3)};
}

ClosedFormChecks validate_impact() {
  constexpr double speed = 0.5, timestep = 1e-4;
  const double energy = 0.5 * kBallMass * speed * speed;
  const double deepest = root([&](double x) { return ball_energy(x) - energy; }, 0, kBallRadius);
  // 2 integral of dx/v from 0 to the depth, with x = deepest sin(t), which removes the pole at the end.
  const auto time = [&](double t) {
    const double left = energy - ball_energy(deepest * std::sin(t));
    return deepest * std::cos(t) / std::sqrt(2 * left / kBallMass);
  };
  const double duration = 2 * integral(time, 0, kPi / 2, 20000);
  Statistic depth, force, length, rebound;
  for (const char* integrator : kIntegrators) {
    SoftOnFloor setup = fine_ball(integrator, 0);
    setup.material.friction = 0;
    setup.start = 1.05 * kBallRadius;
    setup.gravity = dvec3(0);
    setup.timestep = timestep;
    SoftOnFloorRun run(setup);
    run.set_velocity({0, 0, -speed});
    double lowest = kBallRadius, largest = 0;
    int touching = 0;
    for (int n = 0; n < 2000; ++n) {
      const double before = run.velocity().z;
      run.step();
      lowest = std::min(lowest, run.height());
      largest = std::max(largest, kBallMass * (run.velocity().z - before) / timestep);
      touching += run.touching() ? 1 : 0;
      if (touching > 0 && !run.touching()) break;
    }
    depth.add(kBallRadius - lowest, deepest);
    force.add(largest, ball_force(deepest));
    length.add(touching * timestep, duration);
    rebound.add(run.velocity().z, speed);
  }
  const CheckedCase about{"A14", fmt::format("the ball of A11 thrown at the plane with {} m/s, d = 0, no friction, no "
                                             "gravity, steps of 0.1 ms, every integrator",
                                             speed)};
  return {depth.worst(about, "largest depth", "m", 1e-3), force.worst(about, "largest force", "N", 1e-3),
          length.worst(about, "duration", "s", 0.02), rebound.worst(about, "speed of the rebound", "m/s", 1e-3)};
}

ClosedFormChecks validate_rolling_and_impact() {
  ClosedFormChecks all;
  for (const auto& validate : {validate_rolling, validate_spinning, validate_rolling_resistance, validate_impact}) {
    const ClosedFormChecks checks = validate();
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

}  // namespace taxel
