// Taxels on a flat map: undistorted if possible, and never on top of each other.
#include <gtest/gtest.h>

#include "core/layout/field/flat_map.h"

namespace taxel {
namespace {

Layout layout_of(const std::vector<std::pair<dvec3, dvec3>>& places) {
  Layout layout;
  for (const auto& [center, normal] : places) {
    Taxel& taxel = layout.taxels.emplace_back();
    taxel.id = static_cast<int>(layout.taxels.size());
    taxel.center = center;
    taxel.normal = normal;
  }
  return layout;
}

double least_apart(const std::vector<dvec2>& places) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(places[i], places[j]));
  return least;
}

// Seen from the side that the normals point to: distal (z) is up, so right is z x (0, -1, 0) = x.
TEST(FlatMap, KeepsAPlaneUnchanged) {
  std::vector<std::pair<dvec3, dvec3>> grid;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) grid.emplace_back(dvec3(0.01 * i, -0.3, 0.02 * j), dvec3(0, -2, 0));
  const FlatMap map = flat_map(layout_of(grid), dvec3(0.02, 0, 0.01));
  EXPECT_FALSE(map.unrolled);
  for (std::size_t k = 0; k < grid.size(); ++k) {
    EXPECT_NEAR(map.places[k].x, grid[k].first.x - 0.02, 1e-15);
    EXPECT_NEAR(map.places[k].y, grid[k].first.z - 0.01, 1e-15);
  }
  EXPECT_NEAR(map.apart, 0.01, 1e-15);
}

// A ring about z: right is R times the angle from the pad's side, which is -y. Seen from there, +x is to the right.
TEST(FlatMap, UnrollsACylinder) {
  std::vector<std::pair<dvec3, dvec3>> ring;
  const double R = 0.01;
  std::vector<double> angles;
  for (int i = -5; i <= 6; ++i) {
    angles.push_back(i * kPi / 6);
    const dvec3 n(std::sin(angles.back()), -std::cos(angles.back()), 0);
    ring.emplace_back(R * n + dvec3(1, 2, 3), n);
  }
  const FlatMap map = flat_map(layout_of(ring), dvec3(1, 2, 2.5));
  EXPECT_TRUE(map.unrolled);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    EXPECT_NEAR(std::abs(map.places[k].x), R * std::abs(angles[k]), 1e-9);
    if (k + 1 < ring.size()) {
      EXPECT_NEAR(map.places[k].x, R * angles[k], 1e-9);  // the last place is on the seam
    }
    EXPECT_NEAR(map.places[k].y, 0.5, 1e-12);
  }
}

// A finger with a round tip and taxels on all sides. At the pole the places crowd and are moved apart.
TEST(FlatMap, PlacesNoTaxelOverAnotherAroundATip) {
  std::vector<std::pair<dvec3, dvec3>> all;
  const double R = 0.009;
  for (int row = 0; row < 16; ++row) {
    for (int i = 0; i < 15; ++i) {
      const double a = 2 * kPi * (i + 0.5 * (row % 2)) / 15, up = row < 10 ? 0 : (row - 9) * kPi / 13;
      const dvec3 n(std::cos(up) * std::cos(a), std::cos(up) * std::sin(a), std::sin(up));
      all.emplace_back(R * n + dvec3(0, 0, row < 10 ? 0.004 * (row - 9) : 0.0), n);
    }
  }
  const FlatMap map = flat_map(layout_of(all), dvec3(0, 0, -0.01));
  std::vector<double> nearest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double least = 1;
    for (std::size_t j = 0; j < all.size(); ++j)
      if (j != i) least = std::min(least, glm::distance(all[i].first, all[j].first));
    nearest.push_back(least);
  }
  std::sort(nearest.begin(), nearest.end());
  EXPECT_GT(map.apart, 0.6 * nearest[nearest.size() / 2]);
  EXPECT_EQ(map.apart, least_apart(map.places));
  const FlatMap again = flat_map(layout_of(all), dvec3(0, 0, -0.01));
  EXPECT_EQ(again.places, map.places);
}

TEST(FlatMap, SeparatesTaxelsInOnePlace) {
  std::vector<std::pair<dvec3, dvec3>> pile(3, {dvec3(0, -1, 0), dvec3(0, -1, 0)});
  pile.emplace_back(dvec3(0.01, -1, 0), dvec3(0, -1, 0));
  pile.emplace_back(dvec3(0.02, -1, 0), dvec3(0, -1, 0));
  pile.emplace_back(dvec3(0.03, -1, 0), dvec3(0, -1, 0));
  pile.emplace_back(dvec3(0.04, -1, 0), dvec3(0, -1, 0));
  EXPECT_GT(flat_map(layout_of(pile), dvec3(0)).apart, 0.005);
  EXPECT_EQ(flat_map(layout_of({{dvec3(1), dvec3(0, 0, 1)}}), dvec3(0)).apart, 0);
}

}  // namespace
}  // namespace taxel
