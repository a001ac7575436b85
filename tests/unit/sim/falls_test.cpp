// Balls that fall on an undamped soft box with random mass, modulus, time step and integrator. None may gain energy
// without a warning, and the step that the warning names must be stable.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/hydro/contact_stiffness.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

constexpr double kFreeFall = 9.81;  // [m/s^2]

struct Fall {
  std::string integrator;
  double timestep = 0, mass = 0, modulus = 0, thickness = 0, radius = 0, height = 0, friction = 0;
};

Fall random_fall(int trial) {
  const CounterRng rng(77 + static_cast<std::uint64_t>(trial));
  std::uint64_t counter = 0;
  const auto log_uniform = [&](double low, double high) { return low * std::pow(high / low, rng.uniform(counter++)); };
  constexpr const char* kIntegrators[] = {"Euler", "RK4", "implicit", "implicitfast", "discrete"};
  Fall fall;
  fall.integrator = kIntegrators[trial % 5];
  fall.mass = log_uniform(1e-3, 1);
  fall.modulus = log_uniform(1e4, 1e7);
  fall.thickness = log_uniform(0.002, 0.008);
  fall.timestep = log_uniform(1e-4, 5e-3);
  fall.radius = 0.01 + 0.02 * rng.uniform(counter++);
  fall.height = log_uniform(0.003, 0.1);
  fall.friction = trial / 5 % 2 == 0 ? 0 : 0.5;
  return fall;
}

struct Outcome {
  double gain = 0;      ///< largest gain of energy in a flight, as a part of the energy at the start
  double named = 0;     ///< the largest stable step that a warning names [s]; 0 if there is no warning
  double stiffest = 0;  ///< largest h sqrt(k/m) of the states that were sensed
};

Outcome drop(const Fall& fall) {
  test::SensorScene s;
  s.add_sensor("skin", make_box({0.05, 0.05, 0.02}), {FieldKind::pad, fall.modulus, fall.thickness, 0, fall.friction});
  Layout layout = read_layout(s.folder / "skin.taxels.json");
  layout.sampling.density = 1e3;  // readings are not used
  write_layout(s.folder / "skin.taxels.json", layout);
  s.compile(fmt::format("<mujoco><option timestep='{:.17g}' integrator='{}'/>", fall.timestep, fall.integrator) +
            test::sensor_extension("skin", test::key("others", "ball")) +
            fmt::format(R"(<asset><mesh name='skin' file='skin.obj'/></asset><worldbody>
      <geom name='skin' type='mesh' mesh='skin' pos='0 0 -0.02' contype='0' conaffinity='0'/>
      <body pos='0 0 {0}'><freejoint/><inertial mass='{1}' pos='0 0 0' diaginertia='{2} {2} {2}'/>
        <geom name='ball' type='sphere' size='{3}' contype='0' conaffinity='0' friction='{4}'/></body>
      </worldbody></mujoco>)",
                        fall.radius + fall.height, fall.mass, 0.4 * fall.mass * fall.radius * fall.radius, fall.radius,
                        fall.friction));
  Outcome outcome;
  EXPECT_NE(s.model, nullptr) << s.error;
  if (s.model == nullptr) return outcome;
  const double h = fall.timestep;
  const int steps = static_cast<int>(0.35 / h);
  double largest_pressure = 0;
  for (int n = 0; n < steps && s.data->qpos[2] > -0.02; ++n) {
    double kinetic = 0;
    for (int i = 0; i < 3; ++i) kinetic += 0.5 * fall.mass * s.data->qvel[i] * s.data->qvel[i];
    for (int i = 3; i < 6; ++i) kinetic += 0.2 * fall.mass * std::pow(fall.radius * s.data->qvel[i], 2);
    // A flight in semi-implicit steps preserves m g z - h m g v/2 + m v^2/2.
    const double lag = fall.integrator == "RK4" ? 0 : 0.5 * h * s.data->qvel[2];
    const double energy = kinetic + fall.mass * kFreeFall * (s.data->qpos[2] - fall.radius - lag);
    s.step();
    const HydroInstance& sensor = s.sensor();
    const PairState& pair = sensor.sensed().pairs.at(0);
    if (pair.surface.empty()) {
      outcome.gain = std::max(outcome.gain, energy / (fall.mass * kFreeFall * fall.height) - 1);
      continue;
    }
    if (pair.surface.max_pressure() <= largest_pressure) continue;  // the stiffness grows with the depth
    largest_pressure = pair.surface.max_pressure();
    const RigidTransform X_MB(sensor.sensed().X_WM.inverse() * pair.X_WB);
    const Matrix6 K = contact_stiffness(pair.surface, *sensor.contacts().body(), *sensor.touched()[0].body, X_MB);
    outcome.stiffest = std::max(outcome.stiffest, h * std::sqrt(K[2][2] / fall.mass));
  }
  const std::string before = "the largest stable step is ";
  for (const std::string& text : s.sensor().warnings()) {
    const auto at = text.find(before);
    if (at != std::string::npos) outcome.named = std::stod(text.substr(at + before.size()));
  }
  return outcome;
}

/// Counts of many falls.
struct Counts {
  int warned = 0, gained = 0, stable = 0;  ///< stable: h sqrt(k/m) <= 2 and no warning
};

Counts drop_many(int first, int last) {
  constexpr double kGain = 0.01;
  Counts counts;
  for (int trial = first; trial < last; ++trial) {
    Fall fall = random_fall(trial);
    const Outcome outcome = drop(fall);
    counts.warned += outcome.named > 0 ? 1 : 0;
    counts.gained += outcome.gain > kGain ? 1 : 0;
    counts.stable += outcome.named == 0 && outcome.stiffest <= 2 ? 1 : 0;
    if (outcome.named == 0) {
      EXPECT_LE(outcome.gain, kGain) << "fall " << trial << " of " << fall.integrator << " without a warning";
      continue;
    }
    EXPECT_LT(outcome.named, fall.timestep) << trial;
    fall.timestep = outcome.named;
    EXPECT_LE(drop(fall).gain, kGain) << "fall " << trial << " with the step that the warning names";
  }
  return counts;
}

TEST(Falls, GainNoEnergyWithoutAWarning) {
  const Counts counts = drop_many(0, 60);
  EXPECT_GE(counts.stable, 40);
  EXPECT_GE(counts.gained, 3);  // far too large steps are among them
}

TEST(Falls, GainNoEnergyWithoutAWarningInAThousandTrials) {
  const Counts counts = drop_many(0, 1000);
  EXPECT_GE(counts.stable, 800);
  EXPECT_LE(counts.warned, 180);
  EXPECT_GE(counts.gained, 50);
}

}  // namespace
}  // namespace taxel
