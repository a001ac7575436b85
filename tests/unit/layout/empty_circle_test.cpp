// Climbs to the centres of empty circles.
#include "core/layout/sampling/empty_circle.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"

namespace taxel {
namespace {

HoleFinder among(const std::vector<dvec2>& points) {
  HoleFinder finder;
  for (const dvec2& p : points) finder.add(p);
  return finder;
}

TEST(HoleFinder, FindsTheCircumcentreOfATriangle) {
  const std::vector<dvec2> triangle = {dvec2(0, 0), dvec2(1, 0), dvec2(0.4, 0.9)};
  const Hole hole = among(triangle).climb(dvec2(0.2, 0.1), 2.0);
  for (const dvec2& corner : triangle)
    EXPECT_NEAR(glm::distance(hole.center, corner), std::sqrt(hole.clearance), 1e-14);
}

TEST(HoleFinder, NeverComesNearerAndEndsAtALocalMaximum) {
  const CounterRng rng(3);
  std::uint64_t next = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<dvec2> others;
    for (int i = 0; i < 25; ++i) {
      const double x = rng.uniform(next++), y = rng.uniform(next++);
      others.emplace_back(2.0 * x - 1.0, 2.0 * y - 1.0);
    }
    const auto clearance = [&](const dvec2& x) {
      double least = 1e9;
      for (const dvec2& q : others) least = std::min(least, glm::distance(x, q));
      return least;
    };
    const double start_x = rng.uniform(next++), start_y = rng.uniform(next++);
    const dvec2 start(0.2 * start_x, 0.2 * start_y);
    const Hole hole = among(others).climb(start, 0.5);
    EXPECT_GE(clearance(hole.center), clearance(start) - 1e-12);
    EXPECT_NEAR(clearance(hole.center), std::sqrt(hole.clearance), 1e-12);
    if (glm::distance(hole.center, start) > 0.4) continue;  // may have been stopped on the way
    const double step = 1e-4;
    for (int k = 0; k < 16; ++k) {
      const double angle = k * kPi / 8;
      EXPECT_LT(clearance(hole.center + step * dvec2(std::cos(angle), std::sin(angle))), clearance(hole.center) + 1e-9);
    }
  }
}

}  // namespace
}  // namespace taxel
