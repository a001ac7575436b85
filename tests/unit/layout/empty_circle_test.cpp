// The search for the centres of empty circles.
#include "core/layout/sampling/empty_circle.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"

namespace taxel {
namespace {

HoleFinder among(const std::vector<vec2>& points) {
  HoleFinder finder;
  for (const vec2& p : points) finder.add(p);
  return finder;
}

TEST(HoleFinder, FindsTheCircumcentreOfATriangle) {
  const std::vector<vec2> triangle = {vec2(0, 0), vec2(1, 0), vec2(0.4F, 0.9F)};
  const Hole hole = among(triangle).climb(vec2(0.2F, 0.1F), 2.0F);
  for (const vec2& corner : triangle) EXPECT_NEAR(glm::distance(hole.center, corner), std::sqrt(hole.clearance), 1e-6);
}

TEST(HoleFinder, EndsAtALocalMaximumOfTheDistance) {
  const CounterRng rng(3);
  std::uint64_t next = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<vec2> others;
    for (int i = 0; i < 25; ++i) {
      const auto x = static_cast<float>(rng.uniform(next++)), y = static_cast<float>(rng.uniform(next++));
      others.emplace_back(2.0F * x - 1.0F, 2.0F * y - 1.0F);
    }
    const auto clearance = [&](const dvec2& x) {
      double least = 1e9;
      for (const vec2& q : others) least = std::min(least, glm::distance(x, dvec2(q)));
      return least;
    };
    const auto start_x = static_cast<float>(rng.uniform(next++)), start_y = static_cast<float>(rng.uniform(next++));
    const vec2 start(0.2F * start_x, 0.2F * start_y);
    const Hole hole = among(others).climb(start, 0.5F);
    EXPECT_GE(clearance(dvec2(hole.center)), clearance(dvec2(start)) - 1e-6);
    EXPECT_NEAR(clearance(dvec2(hole.center)), std::sqrt(hole.clearance), 1e-6);
    if (glm::distance(hole.center, start) > 0.4) continue;  // the search may have stopped before the centre
    const dvec2 top(hole.center);
    const double step = 1e-3;
    for (int k = 0; k < 16; ++k) {
      const double angle = k * kPi / 8;
      EXPECT_LT(clearance(top + step * dvec2(std::cos(angle), std::sin(angle))), clearance(top) + 1e-6);
    }
  }
}

}  // namespace
}  // namespace taxel
