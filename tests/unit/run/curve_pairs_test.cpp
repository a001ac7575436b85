// Pairs of similar curves that are drawn together.
#include "core/run/plot/curve_styles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"

namespace taxel {
namespace {

using Curves = std::vector<std::vector<double>>;

/// Returns 100 rows of a bell curve of this height around row `middle`.
std::vector<double> bell(double height, double middle) {
  std::vector<double> rows;
  for (int row = 0; row < 100; ++row) rows.push_back(height * std::exp(-0.005 * std::pow(row - middle, 2)));
  return rows;
}

std::vector<int> leaders_of(const Curves& curves) {
  return find_leaders({curves.begin(), curves.end()});
}

TEST(CurvePairs, FindsTwoPairsOfASweep) {
  EXPECT_EQ(leaders_of({bell(30, 60), bell(100, 40), bell(97, 40.5), bell(31, 60)}), (std::vector{-1, -1, 1, 0}));
}

TEST(CurvePairs, DoesNotPairDifferentCurves) {
  EXPECT_EQ(leaders_of({bell(100, 40), bell(70, 40), bell(100, 60)}), (std::vector{-1, -1, -1})) << "height, place";
  EXPECT_EQ(leaders_of({std::vector(9, 0.0), std::vector(9, 0.0)}), (std::vector{-1, -1})) << "nothing was read";
  EXPECT_EQ(leaders_of({{}, {}}), (std::vector{-1, -1}));
}

TEST(CurvePairs, PairsWithTheNearestCurveThatIsInNoPair) {
  EXPECT_EQ(leaders_of({bell(100, 40), bell(90, 40), bell(89, 40)}), (std::vector{-1, 0, -1}))
      << "a pair has two curves";
  EXPECT_EQ(leaders_of({bell(100, 40), bell(76, 40), bell(78, 40)}), (std::vector{-1, -1, 1}));
}

TEST(CurvePairs, PairsOnlyTwinsIfThoseAreKnown) {
  const Curves curves{bell(100, 40), bell(99, 40), bell(98, 40), bell(97, 40), bell(20, 40)};
  const std::vector<std::span<const double>> spans(curves.begin(), curves.end());
  EXPECT_EQ(find_leaders(spans, std::vector{3, 2, 1, 0, -1}), (std::vector{-1, -1, 1, 0, -1}));
  EXPECT_EQ(find_leaders(spans, std::vector{4, -1, -1, -1, 0}), std::vector(5, -1)) << "too far from each other";
}

/// Returns the pairs by the rule, without its short cuts.
std::vector<int> leaders_by_definition(const Curves& curves) {
  std::vector<int> leaders(curves.size(), -1);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    double peak = 0;
    for (const double y : curves[i]) peak = std::max(peak, y);
    double nearest = kPairDistance * peak;
    for (std::size_t j = 0; j < i; ++j) {
      if (leaders[j] >= 0 || std::find(leaders.begin(), leaders.end(), static_cast<int>(j)) != leaders.end()) continue;
      double difference = 0;
      for (std::size_t r = 0; r < curves[i].size(); ++r)
        difference = std::max(difference, std::abs(curves[i][r] - curves[j][r]));
      if (difference < nearest) nearest = difference, leaders[i] = static_cast<int>(j);
    }
  }
  return leaders;
}

TEST(CurvePairs, AgreesWithTheDefinition) {
  const CounterRng rng(11);
  std::uint64_t n = 0;
  int pairs = 0;
  for (int round = 0; round < 50; ++round) {
    Curves curves;
    for (int k = 0; k < 12; ++k, n += 2) curves.push_back(bell(50 + 50 * rng.uniform(n), 30 + 30 * rng.uniform(n + 1)));
    const std::vector<int> leaders = leaders_by_definition(curves);
    EXPECT_EQ(leaders_of(curves), leaders);
    for (const int leader : leaders) pairs += leader >= 0 ? 1 : 0;
  }
  EXPECT_GT(pairs, 50);
}

}  // namespace
}  // namespace taxel
