// The limit of the energy that a contact gives back, against closed forms and against steps of a point on a spring.
#include "core/sim/plugin/forces/explicit_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"

namespace taxel {
namespace {

/// The inverse inertia of a point of 1/`inverse_mass` that moves along z.
Matrix6 along_z(double inverse_mass) {
  Matrix6 A{};
  A[2][2] = inverse_mass;
  return A;
}

TEST(ReleaseShare, GivesBackExactlyTheRest) {
  const CounterRng rng(5);
  std::uint64_t counter = 0;
  const auto random = [&] { return 2 * rng.uniform(counter++) - 1; };
  int whole = 0, exact = 0, least = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Matrix6 B{}, A{};
    for (auto& row : B)
      for (double& x : row) x = random();
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t k = 0; k < 6; ++k) A[i][j] += B[i][k] * B[j][k];
    const Wrench w{{random(), random(), random()}, {random(), random(), random()}};
    const Twist V{{random(), random(), random()}, {random(), random(), random()}};
    const Twist V_end{{random(), random(), random()}, {random(), random(), random()}};
    const double h = 0.1, left = 0.1 * random();
    const double s = release_share(left, w, V, V_end, A, h);
    const std::array<double, 6> v{w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z};
    Twist V_s = V_end;  // + (s - 1) h A w
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        V_s.linear[static_cast<int>(i)] += (s - 1) * h * A[i][j] * v[j];
        V_s.angular[static_cast<int>(i)] += (s - 1) * h * A[i + 3][j] * v[j];
      }
    }
    EXPECT_GE(s, 0);
    EXPECT_LE(s, 1);
    const double given = 0.5 * h * s * (power(w, V) + power(w, V_s));
    if (given < left - 1e-12) {
      EXPECT_EQ(s, 1) << trial;
      ++whole;
    } else if (given <= left + 1e-12) {
      ++exact;
    } else {
      EXPECT_LE(given, 0) << trial << ": it has less than nothing, and gives the least";
      ++least;
    }
  }
  EXPECT_GT(whole, 100);
  EXPECT_GT(exact, 50);
  EXPECT_GT(least, 10);
}

// A point on a spring, thrown at it in steps of any length up to 2 sqrt(m/k) and from any distance: without the limit a
// third gains, by up to a fifth or more; with it none does.
TEST(ReleaseShare, LetsNoBounceOnASpringGainEnergy) {
  const CounterRng rng(6);
  std::uint64_t counter = 0;
  int gains = 0;
  double largest = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double step = 2 * rng.uniform(counter++), start = rng.uniform(counter++);  // m = k = v = 1
    for (const bool is_limited : {false, true}) {
      double z = 0.01 + start * step, v = -1;
      for (int n = 0; n < 100000 && (v < 0 || z < 0); ++n) {
        const double force = std::max(0.0, -z), v_end = v + step * force;
        const double left = 0.5 * force * force + 0.5 * step * force * v;
        const bool may_end = is_limited && force * v_end > 0;
        const double share =
            may_end ? release_share(left, {{0, 0, force}, {}}, {{0, 0, v}, {}}, {{0, 0, v_end}, {}}, along_z(1), step)
                    : 1;
        v += step * share * force;
        z += step * v;
      }
      const double gain = v * v - 1;
      if (is_limited) {
        EXPECT_LT(gain, 1e-9) << "step " << step << ", start " << start;
      } else {
        gains += gain > 0.01 ? 1 : 0;
        largest = std::max(largest, gain);
      }
    }
  }
  EXPECT_GT(gains, 200);
  EXPECT_GT(largest, 0.2);
}

// U = c x^(n+1)/(n+1), K = n c x^(n-1): up to n = 3 the growth of K is below the bound and equal to it for n = 3.
TEST(StiffnessGrowth, BoundsAForceThatIsAPowerOfTheDepth) {
  const double mass = 0.3, speed = 0.7, c = 50;
  for (const int n : {1, 2, 3}) {
    for (const double x : {0.01, 0.05, 0.2}) {
      const double held = c * std::pow(x, n + 1) / (n + 1), force = c * std::pow(x, n);
      const double deepest = std::pow((held + 0.5 * mass * speed * speed) * (n + 1) / c, 1.0 / (n + 1));
      const double exact = std::pow(deepest / x, n - 1);
      const double bound = stiffness_growth(held, {{0, 0, force}, {}}, {{0, 0, -speed}, {}}, along_z(1 / mass));
      EXPECT_GE(bound, exact * (1 - 1e-12)) << n << " " << x;
      if (n == 3) {
        EXPECT_NEAR(bound, exact, 1e-12 * exact);
      }
      EXPECT_EQ(stiffness_growth(held, {{0, 0, force}, {}}, {{0, 0, speed}, {}}, along_z(1 / mass)), 1);  // leaves
    }
  }
  EXPECT_EQ(stiffness_growth(0.1, {{0, 0, 1}, {}}, {{0, 0, -1}, {}}, along_z(0)), 1);  // cannot move
}

}  // namespace
}  // namespace taxel
