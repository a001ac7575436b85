// Several pairs that share bodies, solved together: V = V_free + h A w(V) for all pairs at once.
#include "core/sim/plugin/forces/implicit_wrenches.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kTimestep = 1e-3;

Matrix6 point_inertia(double inverse_mass) {
  Matrix6 A{};
  for (std::size_t i = 0; i < 3; ++i) A[i][i] = inverse_mass;
  return A;
}

Traction friction_of_point(const Twist& V, double mu_normal) {
  const double factor = mu_normal * slip_factor(glm::length(V.linear));
  Traction t;
  for (std::size_t i = 0; i < 3; ++i) t.secant[i][i] = factor;
  t.wrench.force = -factor * V.linear;
  return t;
}

/// A light body between many heavy fingers that all move alike: the fingers take the body along. The remaining relative
/// speed is that of friction against the inertia of the body alone: v (1 + n h/m mu N phi(v)) = v_free.
TEST(ImplicitWrenches, HoldALightBodyBetweenManyFingers) {
  const double mass = 0.01, mu_normal = 1.0, v_free = 0.02;
  for (const std::size_t fingers : {1U, 2U, 5U, 12U}) {
    ImplicitWrenches coupled;
    coupled.begin(fingers, kTimestep);
    for (std::size_t i = 0; i < fingers; ++i) coupled.pair(i).V_free.linear = {0, v_free, 0};
    for (std::size_t i = 0; i < fingers; ++i)
      for (std::size_t j = 0; j < fingers; ++j) coupled.set_inverse_inertia(i, j, point_inertia(1 / mass));
    const auto outcome = coupled.solve([&](std::size_t, const Twist& V) { return friction_of_point(V, mu_normal); });
    EXPECT_TRUE(outcome.converged);
    EXPECT_LE(outcome.evaluations, 25) << fingers;
    double lo = 0, hi = v_free;
    for (int k = 0; k < 200; ++k) {
      const double v = 0.5 * (lo + hi);
      (v * (1 + static_cast<double>(fingers) * kTimestep / mass * mu_normal * slip_factor(v)) < v_free ? lo : hi) = v;
    }
    for (std::size_t i = 0; i < fingers; ++i) EXPECT_NEAR(coupled.pair(i).V_end.linear.y, lo, 1e-6 * v_free) << i;
  }
}

/// Soft balls on planes whose bodies are coupled at random: the equation holds for all pairs.
TEST(ImplicitWrenches, SolveTheEquationOfRealSurfaces) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(5e4), 0.006);
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const PairProperties properties{5.0, 0.5};
  const CounterRng rng(11);
  std::uint64_t counter = 0;
  const auto random = [&] { return 2 * rng.uniform(counter++) - 1; };
  const auto random_vector = [&] {
    dvec3 v;
    for (int k = 0; k < 3; ++k) v[k] = random();  // one after the other: compilers evaluate arguments in any order
    return v;
  };
  for (const std::size_t pairs : {1U, 2U, 5U}) {
    // Without halved steps, trial 0 with one pair and trial 252 with two end in cycles.
    for (int trial = 0; trial < (pairs == 2 ? 260 : 12); ++trial) {
      std::vector<Contact> contacts;
      for (std::size_t i = 0; i < pairs; ++i)
        contacts.push_back(
            touch(*ball, *floor, Pose{{1, 0, 0, 0}, {0, 0, 0.0185 + 0.0002 * static_cast<double>(i)}}, {}));
      const auto law = [&](std::size_t i, const Twist& V) { return traction(contacts[i].surface, properties, V); };
      const std::size_t n = 6 * pairs;
      std::vector<double> B(n * n), A(n * n);
      for (std::size_t i = 0; i < n * n; ++i) B[i] = (i / n % 6 < 3 ? 3 : 300) * random();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t k = 0; k < n; ++k) A[i * n + j] += B[i * n + k] * B[j * n + k];
      ImplicitWrenches coupled;
      coupled.begin(pairs, kTimestep);
      for (std::size_t i = 0; i < pairs; ++i) {
        auto& pair = coupled.pair(i);
        pair.length = 0.02;
        pair.V_free.linear = 0.1 * random_vector();
        pair.V_free.angular = 5.0 * random_vector();
      }
      for (std::size_t i = 0; i < pairs; ++i) {
        for (std::size_t j = 0; j < pairs; ++j) {
          Matrix6 block{};
          for (std::size_t r = 0; r < 6; ++r)
            for (std::size_t c = 0; c < 6; ++c) block[r][c] = A[(6 * i + r) * n + 6 * j + c];
          coupled.set_inverse_inertia(i, j, block);
        }
      }
      EXPECT_TRUE(coupled.solve(law).converged) << pairs << ", trial " << trial;
      double error = 0, size = 0;
      const auto at = [](const dvec3& a, const dvec3& b, std::size_t k) {
        return k < 3 ? a[static_cast<int>(k)] : b[static_cast<int>(k) - 3];
      };
      for (std::size_t i = 0; i < n; ++i) {
        double impulse = 0;
        for (std::size_t j = 0; j < n; ++j) {
          const Wrench w = law(j / 6, coupled.pair(j / 6).V_end).wrench;
          impulse += kTimestep * A[i * n + j] * at(w.force, w.torque, j % 6);
        }
        const auto& pair = coupled.pair(i / 6);
        const double scale = i % 6 < 3 ? 1 : pair.length;
        error += std::pow(scale * (at(pair.V_end.linear, pair.V_end.angular, i % 6) -
                                   at(pair.V_free.linear, pair.V_free.angular, i % 6) - impulse),
                          2);
        size += std::pow(scale * impulse, 2);
      }
      EXPECT_LE(std::sqrt(error), 1e-5 * std::sqrt(size)) << pairs << ", trial " << trial;
    }
  }
}

}  // namespace
}  // namespace taxel
