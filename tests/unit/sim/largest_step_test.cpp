// The largest stable step, compared with the steps themselves and in scenes.
#include "core/sim/plugin/forces/explicit_step.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;
using Vector6 = std::array<double, 6>;

Vector6 times(const Matrix6& m, const Vector6& v) {
  Vector6 r{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) r[i] += m[i][j] * v[j];
  return r;
}

/// Returns B B^T of random numbers, with `rank` columns.
Matrix6 random_positive(const CounterRng& rng, std::uint64_t& counter, double scale, std::size_t rank) {
  Matrix6 B{}, P{};
  for (auto& row : B)
    for (std::size_t j = 0; j < rank; ++j) row[j] = 2 * rng.uniform(counter++) - 1;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t k = 0; k < rank; ++k) P[i][j] += scale * B[i][k] * B[j][k];
  return P;
}

/// Makes many steps directly: V+ = V - h A (K x + S V+), x+ = x + h V+. Returns how much larger the motion was in the
/// second half.
double growth(const ContactMode& mode, double h, int steps) {
  Vector6 x{1e-3, -2e-3, 1.5e-3, 0.7e-3, -1.1e-3, 0.4e-3}, V{};
  const auto size = [&] {
    double sum = 0;
    for (const double v : x) sum += v * v;
    return std::sqrt(sum);
  };
  double first = 0, last = 0;
  for (int n = 0; n < steps; ++n) {
    Vector6 b = times(mode.inverse_inertia, times(mode.stiffness, x));
    for (std::size_t i = 0; i < 6; ++i) b[i] = V[i] - h * b[i];
    Matrix6 m{};  // I + h A S
    for (std::size_t i = 0; i < 6; ++i) {
      m[i][i] = 1;
      for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t k = 0; k < 6; ++k) m[i][j] += h * mode.inverse_inertia[i][k] * mode.damping[k][j];
    }
    for (std::size_t k = 0; k < 6; ++k) {  // the diagonal is not close to 0 here, so no pivoting is needed
      for (std::size_t i = 0; i < 6; ++i) {
        if (i == k) continue;
        const double f = m[i][k] / m[k][k];
        for (std::size_t j = 0; j < 6; ++j) m[i][j] -= f * m[k][j];
        b[i] -= f * b[k];
      }
    }
    for (std::size_t i = 0; i < 6; ++i) {
      V[i] = b[i] / m[i][i];
      x[i] += h * V[i];
    }
    (n < steps / 2 ? first : last) = std::max(n < steps / 2 ? first : last, size());
  }
  return last / first;
}

TEST(LargestStep, IsTheStepAtWhichMotionBeginsToGrow) {
  const CounterRng rng(3);
  std::uint64_t counter = 0;
  for (int trial = 0; trial < 60; ++trial) {
    ContactMode mode;
    mode.inverse_inertia = random_positive(rng, counter, 50, trial % 3 == 0 ? 3 : 6);
    mode.stiffness = random_positive(rng, counter, 1e4, trial % 2 == 0 ? 6 : 4);
    if (trial % 4 != 0) mode.damping = random_positive(rng, counter, 2, 2);
    const double h = largest_stable_step(mode, 1.0);
    ASSERT_LT(h, 0.1);
    EXPECT_LT(growth(mode, 0.999 * h, 400), 2) << trial;
    EXPECT_GT(growth(mode, 1.02 * h, 400), 100) << trial;
    EXPECT_EQ(largest_stable_step(mode, 0.9 * h), 0.9 * h);
  }
}

TEST(LargestStep, EqualsTheClosedFormForAMassOnASpring) {
  ContactMode mode;
  mode.inverse_inertia[2][2] = 1 / 0.001;
  mode.stiffness[2][2] = 4e4;
  EXPECT_NEAR(largest_stable_step(mode, 1), 2 / std::sqrt(4e7), 1e-9);
  EXPECT_NEAR(largest_stable_step(mode, 1e10), 2 / std::sqrt(4e7), 1e-9);  // from any start value
  mode.damping[2][2] = 3;                                                  // h^2 lambda = 4 + 2 h sigma
  const double lambda = 4e7, sigma = 3e3;
  EXPECT_NEAR(largest_stable_step(mode, 1), (sigma + std::sqrt(sigma * sigma + 4 * lambda)) / lambda, 1e-9);
}

TEST(LargestStep, IsBoundedByTheQuickBound) {
  const CounterRng rng(4);
  std::uint64_t counter = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ContactMode mode;
    mode.inverse_inertia = random_positive(rng, counter, 50, 6);
    double linear = 0, reach = 0;
    for (int point = 0; point < 5; ++point) {
      const auto random = [&] { return 2 * rng.uniform(counter++) - 1; };
      const dvec3 n = glm::normalize(dvec3(random(), random(), random())), x(random(), random(), random());
      const dvec3 m = glm::cross(x, n);
      const double k = 100 * rng.uniform(counter++);
      const Vector6 u{n.x, n.y, n.z, m.x, m.y, m.z};
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) mode.stiffness[i][j] += k * u[i] * u[j];
      linear += k;
      reach = std::max(reach, glm::length(x));
    }
    const double h = largest_stable_step(mode, 1);
    EXPECT_GE(stiffest_mode_bound(mode.inverse_inertia, linear, reach), kStepLimit / (h * h) * (1 - 1e-9));
  }
}

/// A finger of 1 g with a flat pad of E/H = 2e8 Pa/m on 4 cm^2, pressed on a plane with 10 N: k = 8e4 N/m.
struct LightFinger {
  SensorScene s;
  LightFinger(const std::string& integrator, double timestep, const std::string& joint, double dissipation) {
    s.add_sensor("pad", make_box({0.01, 0.01, 0.005}), {FieldKind::pad, 4e5, 0.002, dissipation, 0});
    s.compile("<mujoco><option gravity='0 0 0' integrator='" + integrator + "' timestep='" +
              fmt::format("{}", timestep) + "'/>" + sensor_extension("pad", key("others", "floor")) +
              "<asset><mesh name='pad' file='pad.obj'/></asset><worldbody>"
              "<geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>"
              "<body name='finger' pos='0 0 0.006'>" +
              joint +
              "<inertial mass='0.001' pos='0 0 0' diaginertia='2e-8 2e-8 4e-8'/>"
              "<geom name='pad' type='mesh' mesh='pad' contype='0' conaffinity='0'/></body></worldbody></mujoco>");
  }
  /// Moves the pad to its equilibrium at 10 N, and a nanometre away.
  void press(double depth) {
    s.data->qpos[2 * (s.model->nq > 1)] = (s.model->nq > 1 ? 0.005 : -0.001) - depth;
    mj_forward(s.model.get(), s.data.get());
    const double force = pressure_wrench(s.sensor().sensed().pairs.at(0).surface).force.z;
    s.data->xfrc_applied[6 * mj_name2id(s.model.get(), mjOBJ_BODY, "finger") + 2] = -force;
    s.data->qpos[2 * (s.model->nq > 1)] -= 1e-9;
  }
  /// Returns the largest distance from the start over some steps, which is about 1e-9 m if the motion does not grow.
  double wander(int steps) {
    const int q = 2 * (s.model->nq > 1);
    const double start = s.data->qpos[q] + 1e-9;
    double largest = 0;
    for (int n = 0; n < steps; ++n) {
      s.step();
      largest = std::max(largest, std::abs(s.data->qpos[q] - start));
    }
    return largest;
  }
  [[nodiscard]] int times_warned() const {
    int count = 0;
    for (const std::string& text : s.sensor().warnings()) count += text.find("largest stable") != std::string::npos;
    return count;
  }
  /// Returns the step in the warning, or 0 if there is no warning.
  [[nodiscard]] double warned() const {
    for (const std::string& text : s.sensor().warnings()) {
      const std::string before = "largest stable step is ";
      const auto at = text.find(before);
      if (at == std::string::npos) continue;
      EXPECT_NE(text.find("\"pad\""), std::string::npos);
      EXPECT_NE(text.find("\"floor\""), std::string::npos);
      EXPECT_NE(text.find(fmt::format("{:.4g}", s.model->opt.timestep)), std::string::npos) << text;
      return std::stod(text.substr(at + before.size()));
    }
    return 0;
  }
};

const char* const kSlide = "<joint name='z' type='slide' axis='0 0 1'/>";

TEST(LargestStep, IsNamedOnceByACorrectWarning) {
  for (const char* integrator : {"Euler", "implicit", "implicitfast", "discrete", "RK4"}) {
    LightFinger finger(integrator, 0.002, kSlide, 0);
    ASSERT_NE(finger.s.model, nullptr) << finger.s.error;
    finger.s.step(20);
    EXPECT_EQ(finger.warned(), 0) << "not touching";
    finger.press(0.0001);
    finger.s.step();
    const double named = finger.warned();
    finger.s.step(20);
    EXPECT_EQ(finger.times_warned(), 1);
    EXPECT_NEAR(named, 2 * std::sqrt(0.001 / 8e4), 0.1 * named) << integrator;

    for (const double part : {0.5, 0.95}) {
      LightFinger below(integrator, part * named, kSlide, 0);
      below.press(0.0001);
      EXPECT_LT(below.wander(5000), 1e-8) << integrator << " at " << part;
      EXPECT_EQ(below.warned(), 0);
    }
    for (const double part : {1.06, 2.0}) {
      LightFinger above(integrator, part * named, kSlide, 0);
      above.press(0.0001);
      const double wander = above.wander(1000);
      // RK4 keeps a contact steady that never opens, up to sqrt(2) times the step at which a bouncing one gains energy.
      if (std::string(integrator) != "RK4" || part > std::sqrt(2)) {
        EXPECT_GT(wander, 1e-6) << integrator << " at " << part;
      }
      EXPECT_NEAR(above.warned(), named, 0.02 * named);
    }
  }
}

TEST(LargestStep, IncludesTheRockingOfAFreeFinger) {
  LightFinger first("Euler", 0.002, "<freejoint/>", 0);
  ASSERT_NE(first.s.model, nullptr) << first.s.error;
  first.press(0.0001);
  first.s.step();
  const double named = first.warned();
  ASSERT_GT(named, 0);
  EXPECT_LT(named, 0.9 * 2 * std::sqrt(0.001 / 8e4));
  const auto tilt_after = [](double timestep) {
    LightFinger finger("Euler", timestep, "<freejoint/>", 0);
    finger.press(0.0001);
    finger.s.data->qpos[4] = 1e-9;
    finger.s.data->qpos[5] = 2e-9;
    double largest = 0;
    for (int n = 0; n < 1000; ++n) {
      finger.s.step();
      largest = std::max({largest, std::abs(finger.s.data->qpos[4]), std::abs(finger.s.data->qpos[5])});
    }
    return largest;
  };
  EXPECT_LT(tilt_after(0.9 * named), 1e-7);
  EXPECT_GT(tilt_after(1.1 * named), 1e-5);
}

TEST(LargestStep, GrowsWithDamping) {
  LightFinger plain("Euler", 0.002, kSlide, 0), damped("Euler", 0.002, kSlide, 5.0);
  for (LightFinger* finger : {&plain, &damped}) {
    finger->press(0.0001);
    finger->s.step();
  }
  const double named = damped.warned();
  EXPECT_GT(named, 1.005 * plain.warned());
  LightFinger below("Euler", 0.97 * named, kSlide, 5.0), above("Euler", 1.03 * named, kSlide, 5.0);
  below.press(0.0001);
  above.press(0.0001);
  EXPECT_LT(below.wander(3000), 1e-8);
  EXPECT_GT(above.wander(3000), 1e-6);
}

}  // namespace
}  // namespace taxel
