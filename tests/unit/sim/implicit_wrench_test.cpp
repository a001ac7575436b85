// The equation of one implicit step: V = V_free + h A w(V).
#include "core/sim/plugin/forces/implicit_wrenches.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kMass = 0.1, kStep = 1e-3;

/// Friction of a point mass under a normal force `normal` [N]: t = -(2/pi) mu N atan(v/vs) v/|v|.
Traction point_friction(const Twist& V, double mu_normal) {
  const double v = glm::length(V.linear);
  const double factor = v > 0 ? 2 / kPi * mu_normal * std::atan(v / kSlipSpeed) / v : 2 / kPi * mu_normal / kSlipSpeed;
  Traction t;
  for (std::size_t i = 0; i < 3; ++i) t.secant[i][i] = factor;
  t.wrench.force = -factor * V.linear;
  return t;
}

/// A single pair.
struct OnePair {
  Matrix6 inverse_inertia{};
  Twist V_start, V_free;
  double timestep = kStep, length = 0.01;
};
struct Solved : ImplicitWrenches::Pair, ImplicitWrenches::Outcome {};
Solved solve(const OnePair& step, const std::function<Traction(const Twist&)>& law) {
  ImplicitWrenches wrenches;
  wrenches.begin(1, step.timestep);
  wrenches.pair(0) = {step.V_start, step.V_free, step.length, {}, {}};
  wrenches.set_inverse_inertia(0, 0, step.inverse_inertia);
  const ImplicitWrenches::Outcome outcome = wrenches.solve([&](std::size_t, const Twist& V) { return law(V); });
  return {wrenches.pair(0), outcome};
}

OnePair free_point(double v_now, double v_free) {
  OnePair step;
  for (std::size_t i = 0; i < 3; ++i) step.inverse_inertia[i][i] = 1 / kMass;
  step.V_start.linear = {v_now, 0, 0};
  step.V_free.linear = {v_free, 0, 0};
  return step;
}

/// Solves the equation in one unknown by bisection: v + h/m (2/pi) mu N atan(v/vs) grows with v.
double bisected(double v_free, double mu_normal) {
  double lo = 0, hi = v_free;
  for (int i = 0; i < 200; ++i) {
    const double v = 0.5 * (lo + hi);
    (v + kStep / kMass * 2 / kPi * mu_normal * std::atan(v / kSlipSpeed) < v_free ? lo : hi) = v;
  }
  return lo;
}

TEST(ImplicitWrench, EqualsBisectionForPointFrictionAtAnySpeed) {
  const double mu_normal = 0.5;  // stops up to h mu N/m = 5 mm/s
  for (const double v_free : {1e-7, 1e-5, 1e-3, 4.9e-3, 5.0e-3, 5.1e-3, 1e-2, 1.0}) {
    for (const double v_now : {0.0, v_free, 10.0}) {
      const Solved solved =
          solve(free_point(v_now, v_free), [&](const Twist& V) { return point_friction(V, mu_normal); });
      EXPECT_TRUE(solved.converged);
      EXPECT_LE(solved.evaluations, 20);
      EXPECT_NEAR(solved.V_end.linear.x, bisected(v_free, mu_normal), 1e-6 * v_free) << v_free << " from " << v_now;
    }
  }
}

TEST(ImplicitWrench, StopsASlidingBlockWithoutReversal) {
  double v = 0.05;
  for (int n = 0; n < 200; ++n) {
    const double before = v;
    v = solve(free_point(v, v), [](const Twist& V) { return point_friction(V, 0.5); }).V_end.linear.x;
    EXPECT_GE(v, 0.0);
    EXPECT_LT(v, before);
  }
  EXPECT_LT(v, 1e-8);
}

TEST(ImplicitWrench, KeepsTheTwistOfImmovableBodies) {
  OnePair step = free_point(0.2, 0.3);
  step.inverse_inertia = {};
  const Solved solved = solve(step, [](const Twist& V) { return point_friction(V, 0.5); });
  EXPECT_TRUE(solved.converged);
  EXPECT_EQ(solved.V_end.linear, dvec3(0.3, 0, 0));
  EXPECT_NEAR(solved.wrench.force.x, point_friction({dvec3(0.3, 0, 0), dvec3(0)}, 0.5).wrench.force.x, 1e-12);
}

/// A soft ball pressed into a plane, about a point far off its centre, with every kind of motion: the equation holds.
TEST(ImplicitWrench, SolvesTheEquationOfARealSurface) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(5e4), 0.006);
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const Contact contact = touch(*ball, *floor, Pose{{1, 0, 0, 0}, {0, 0, 0.018}}, Pose{});
  const PairProperties pair{5.0, 0.5};
  const auto law = [&](const Twist& V) { return traction(contact.surface, pair, V); };
  const CounterRng rng(7);
  std::uint64_t counter = 0;
  const auto random = [&](double scale) {
    const auto u = [&] { return scale * (2 * rng.uniform(counter++) - 1); };
    return dvec3(u(), u(), u());
  };
  for (int trial = 0; trial < 100; ++trial) {
    OnePair step;
    step.timestep = trial % 2 == 0 ? 1e-3 : 4e-3;
    step.length = 0.02;
    // A = B B^T of a body of 20 g that is constrained in some directions.
    std::array<std::array<double, 6>, 6> B{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) B[i][j] = (i < 3 ? 3 : 300) * (2 * rng.uniform(counter++) - 1);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t k = 0; k < 6; ++k) step.inverse_inertia[i][j] += B[i][k] * B[j][k];
    const double speed = std::pow(10.0, -5 + 5 * rng.uniform(counter++));
    step.V_free = {random(speed), random(50 * speed)};
    step.V_start = {random(speed), random(50 * speed)};

    const Solved solved = solve(step, law);
    EXPECT_TRUE(solved.converged) << "trial " << trial;
    const Wrench w = law(solved.V_end).wrench;
    double error = 0, size = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto at = [&](const dvec3& a, const dvec3& b, std::size_t k) {
        return k < 3 ? a[static_cast<int>(k)] : b[static_cast<int>(k) - 3];
      };
      double impulse = 0;
      for (std::size_t j = 0; j < 6; ++j)
        impulse += step.timestep * step.inverse_inertia[i][j] * at(w.force, w.torque, j);
      const double scale = i < 3 ? 1 : step.length;
      const double free = at(step.V_free.linear, step.V_free.angular, i);
      error += std::pow(scale * (at(solved.V_end.linear, solved.V_end.angular, i) - free - impulse), 2);
      size += std::pow(scale * impulse, 2);
    }
    EXPECT_LE(std::sqrt(error), 1e-5 * std::sqrt(size)) << "trial " << trial;
    EXPECT_LE(glm::length(solved.wrench.force - w.force), 1e-5 * glm::length(w.force)) << "trial " << trial;
  }
}

}  // namespace
}  // namespace taxel
