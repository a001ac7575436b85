// Thinned curves compared with the original curves.
#include "core/base/page/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/rng.h"

namespace taxel {
namespace {

struct Curve {
  std::vector<double> x, y;
};

/// Returns a random walk with jumps and rests. The x value sometimes stays constant.
Curve random_curve(std::uint64_t seed, std::size_t points) {
  const CounterRng rng(seed);
  std::uint64_t n = 0;
  Curve c;
  double x = 0, y = 0;
  for (std::size_t i = 0; i < points; ++i) {
    x += rng.uniform(n++) < 0.1 ? 0.0 : rng.uniform(n++);
    const double what = rng.uniform(n++);
    if (what < 0.3) y += rng.uniform(n++) - 0.5;
    if (what > 0.98) y += 20 * (rng.uniform(n++) - 0.5);
    c.x.push_back(x);
    c.y.push_back(y);
  }
  return c;
}

/// Returns the height of the polyline at x, where the polyline is not vertical.
double at(const CurvePoints& line, double x) {
  const auto after = std::upper_bound(line.x.begin(), line.x.end(), x);
  if (after == line.x.end()) return line.y.back();
  const auto i = static_cast<std::size_t>(after - line.x.begin());
  const double t = (x - line.x[i - 1]) / (line.x[i] - line.x[i - 1]);
  return line.y[i - 1] + t * (line.y[i] - line.y[i - 1]);
}

TEST(ThinCurve, StaysWithinToleranceOfEveryPointWithOnePerColumn) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Curve c = random_curve(seed, 600);
    for (std::size_t i = 0; i < c.x.size(); ++i) c.x[i] = static_cast<double>(i);
    CurvePoints thin;
    thin_curve(c.x, c.y, 1.0, 0.25, thin);
    for (std::size_t i = 0; i < c.x.size(); ++i) EXPECT_NEAR(at(thin, c.x[i]), c.y[i], 0.25 + 1e-9) << seed << " " << i;
    EXPECT_LT(thin.x.size(), c.x.size());
  }
}

TEST(ThinCurve, KeepsTheExtremesOfEveryColumn) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Curve c = random_curve(seed, 5000);
    constexpr double kColumn = 10, kTolerance = 0.25;
    CurvePoints thin;
    thin_curve(c.x, c.y, kColumn, kTolerance, thin);
    std::map<long, std::pair<double, double>> given, drawn;
    const auto note = [&](auto& columns, double x, double y) {
      auto [it, is_new] = columns.try_emplace(std::lround(std::floor((x - c.x.front()) / kColumn)), y, y);
      it->second = {std::min(it->second.first, y), std::max(it->second.second, y)};
    };
    for (std::size_t i = 0; i < c.x.size(); ++i) note(given, c.x[i], c.y[i]);
    for (const double x : c.x) note(drawn, x, at(thin, x));
    for (std::size_t i = 0, j = 0; i < thin.x.size(); ++i) {
      note(drawn, thin.x[i], thin.y[i]);
      while (j < c.x.size() && (c.x[j] != thin.x[i] || c.y[j] != thin.y[i])) ++j;
      ASSERT_LT(j, c.x.size()) << "a point of the curve, in its order";
    }
    for (const auto& [column, range] : given) {
      EXPECT_LE(drawn[column].first, range.first + kTolerance + 1e-9) << seed;
      EXPECT_GE(drawn[column].second, range.second - kTolerance - 1e-9) << seed;
    }
    EXPECT_LE(thin.x.size(), 4 * given.size());
    EXPECT_TRUE(std::is_sorted(thin.x.begin(), thin.x.end()));
  }
}

TEST(ThinCurve, KeepsOnlyTheEndsOfAStraightLine) {
  Curve c;
  for (int i = 0; i <= 1000; ++i) c.x.push_back(i), c.y.push_back(3 + 0.5 * i);
  CurvePoints thin;
  thin_curve(c.x, c.y, 1.0, 0.01, thin);
  EXPECT_EQ(thin.x, (std::vector<double>{0, 1000}));
  EXPECT_EQ(thin.y, (std::vector<double>{3, 503}));
  thin_curve({}, {}, 1.0, 0.1, thin);
  EXPECT_TRUE(thin.x.empty());
  const double one[] = {2};
  thin_curve(one, one, 1.0, 0.1, thin);
  EXPECT_EQ(thin.x, std::vector<double>{2});
}

TEST(ThinCurve, KeepsAStepAsAStep) {
  Curve c;
  for (int i = 0; i < 100; ++i) c.x.push_back(i), c.y.push_back(i < 50 ? 0 : 7);
  CurvePoints thin;
  thin_curve(c.x, c.y, 1.0, 0.1, thin);
  EXPECT_EQ(thin.x, (std::vector<double>{0, 49, 50, 99}));
}

TEST(ThinPath, KeepsTheExtremesOfALoop) {
  std::vector<double> x, y;
  for (int i = 0; i < 40'000; ++i) {
    const double t = 1e-3 * i;
    x.push_back(10 * std::sin(t)), y.push_back(std::cos(t) + (i == 12'345 ? 3 : 0) - (i == 30'001 ? 4 : 0));
  }
  const CurvePoints path = thin_path(x, y, 0.1, 0.001);
  EXPECT_LT(path.x.size(), 6000U);
  EXPECT_EQ(path.x.size(), path.y.size());
  EXPECT_EQ(*std::max_element(path.y.begin(), path.y.end()), y[12'345]);
  EXPECT_EQ(*std::min_element(path.y.begin(), path.y.end()), y[30'001]);
  EXPECT_EQ(path.x.front(), x.front());
  EXPECT_EQ(path.x.back(), x.back());
  EXPECT_EQ(*std::min_element(path.x.begin(), path.x.end()), *std::min_element(x.begin(), x.end()));
  EXPECT_EQ(thin_path(std::vector<double>{1, 1, 0}, std::vector<double>{5, 6, 7}, 0.1, 0.001).x.size(), 3U);
}

}  // namespace
}  // namespace taxel
