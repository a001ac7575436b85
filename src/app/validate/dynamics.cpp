#include "app/validate/dynamics.h"

#include <fmt/format.h>

#include "app/validate/soft_ball.h"
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

}  // namespace taxel
