// What lies in a lasso.
#include "ui/tools/area_select.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"

namespace taxel::ui {
namespace {

/// Times that a closed path goes round a point, from the angles that its pieces turn by: another way to the same.
int winding(const std::vector<dvec2>& corners, const dvec2& p) {
  double turned = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i] - p, b = corners[(i + 1) % corners.size()] - p;
    turned += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
  }
  return static_cast<int>(std::lround(turned / (2 * glm::pi<double>())));
}

TEST(AreaSelect, APolygonHoldsWhatItGoesRoundAnOddNumberOfTimes) {
  const CounterRng rng(3);
  int inside = 0;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    std::vector<dvec2> corners;
    const std::uint64_t count = 3 + rng.bits(1000 * trial) % 9;
    for (std::uint64_t i = 0; i < count; ++i)
      corners.emplace_back(rng.uniform(1000 * trial + 2 * i + 1), rng.uniform(1000 * trial + 2 * i + 2));
    for (std::uint64_t k = 0; k < 50; ++k) {
      const dvec2 p(rng.uniform(1000 * trial + 100 + 2 * k), rng.uniform(1000 * trial + 101 + 2 * k));
      const bool odd = winding(corners, p) % 2 != 0;
      EXPECT_EQ(in_polygon(corners, p), odd) << trial << " " << k;
      inside += odd;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(AreaSelect, LessThanATriangleHoldsNothing) {
  EXPECT_FALSE(in_polygon({}, {0, 0}));
  EXPECT_FALSE(in_polygon({{0, 0}}, {0, 0}));
  EXPECT_FALSE(in_polygon({{0, 0}, {1, 1}}, {0.5, 0.5}));
}

}  // namespace
}  // namespace taxel::ui
