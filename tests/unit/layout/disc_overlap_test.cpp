// The overlap of two discs, compared with closed forms and with random points.
#include "core/layout/field/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/rng.h"

namespace taxel {
namespace {

Taxel taxel_at(const dvec3& center, double radius, const dvec3& normal = dvec3(0, 0, 1)) {
  return {0, "", center, normal, radius, {}};
}

/// Finds the pairs by comparing every pair of taxels.
std::vector<std::tuple<std::size_t, std::size_t>> pairs_by_hand(const std::vector<Taxel>& taxels, double least) {
  std::vector<std::tuple<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < taxels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Taxel &a = taxels[i], &b = taxels[j];
      if (disc_overlap(a.radius, b.radius, glm::distance(a.center, b.center)) <= least) continue;
      if (glm::dot(a.normal, b.normal) < std::sqrt(0.5)) continue;
      pairs.emplace_back(i, j);
      break;
    }
  return pairs;
}

TEST(DiscOverlap, EqualsClosedForms) {
  EXPECT_EQ(disc_overlap(2, 2, 0), 1);
  EXPECT_EQ(disc_overlap(2, 2, 4), 0);
  EXPECT_EQ(disc_overlap(1, 2, 0.9), 0.25) << "inside";
  EXPECT_EQ(disc_overlap(2, 1, 0.9), 0.25) << "either order";
  // Equal discs whose rims pass through each other's centres share 2/3 - sqrt(3) / (2 pi).
  EXPECT_NEAR(disc_overlap(3, 3, 3), 2.0 / 3 - std::sqrt(3.0) / (2 * std::numbers::pi), 1e-15);
  // Radii 1 and sqrt(3), 2 apart (rims at right angles): (1 acos(1/2) + 3 acos(sqrt(3)/2) - sqrt(3)) / 3 pi.
  const double area = std::acos(0.5) + 3 * std::acos(std::sqrt(0.75)) - std::sqrt(3.0);
  EXPECT_NEAR(disc_overlap(1, std::sqrt(3.0), 2), area / (3 * std::numbers::pi), 1e-15);
}

TEST(DiscOverlap, EqualsTheFractionOfPointsInBothDiscs) {
  const CounterRng rng(5);
  std::uint64_t n = 0;
  const auto uniform = [&] { return static_cast<double>(rng.bits(n++) >> 11U) * 0x1p-53; };
  for (const auto& [r, d] : {std::pair(0.5, 0.8), std::pair(0.9, 0.3), std::pair(0.97, 0.2)}) {
    int inside = 0, both = 0;
    while (inside < 100000) {
      const double x = 2 * uniform() - 1, y = 2 * uniform() - 1;
      if (x * x + y * y > 1) continue;
      ++inside;
      both += (x - d) * (x - d) + y * y <= r * r ? 1 : 0;
    }
    EXPECT_NEAR(disc_overlap(1, r, d), both * 1e-5, 0.006) << r << " " << d;  // four standard deviations
  }
}

TEST(DiscOverlap, FindsTheFirstEarlierTaxelOfEach) {
  const CounterRng rng(7);
  std::uint64_t n = 0;
  const auto uniform = [&] { return static_cast<double>(rng.bits(n++) >> 11U) * 0x1p-53; };
  std::vector<Taxel> taxels;
  for (int i = 0; i < 300; ++i) {
    const dvec3 place(0.01 * uniform(), 0.01 * uniform(), 0.002 * uniform());
    const double radius = i % 50 == 0 ? 1.0 : 0.0015 + 0.001 * uniform();
    taxels.push_back(taxel_at(place, radius, i % 3 == 0 ? dvec3(0, 0, -1) : dvec3(0, 0, 1)));
  }
  std::vector<std::tuple<std::size_t, std::size_t>> found;
  for (const OverlappingTaxels& pair : overlapping_taxels(taxels)) {
    found.emplace_back(pair.taxel, pair.earlier);
    EXPECT_GT(pair.part, kLargeOverlap);
  }
  EXPECT_EQ(found, pairs_by_hand(taxels, kLargeOverlap));
  EXPECT_GT(found.size(), 20U);
  EXPECT_LT(found.size(), 290U);
}

TEST(DiscOverlap, OmitsTaxelsThatAreNoDiscs) {
  const double nan = std::nan("");
  EXPECT_TRUE(overlapping_taxels({taxel_at(dvec3(0), 1), taxel_at(dvec3(nan), 1), taxel_at(dvec3(0.01), -1),
                                  taxel_at(dvec3(0.02), nan), taxel_at(dvec3(0.03), 1, dvec3(0))})
                  .empty());
  EXPECT_TRUE(overlapping_taxels({}).empty());
  EXPECT_TRUE(overlapping_taxels({taxel_at(dvec3(0), 1), taxel_at(dvec3(0), 1)}).empty())
      << "the same place is said by another check";
}

}  // namespace
}  // namespace taxel
