// Differences of convex polygons: holes are subtracted from a polygon.
#include "core/hydro/kernel/covered_region.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/flat_polygons.h"

namespace taxel {
namespace {
using test::area_of;
using test::contains;

/// Returns a convex polygon of `count` corners on a circle, at random angles.
FlatPolygon random_polygon(const CounterRng& rng, std::uint64_t seed, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(2 * kPi * rng.uniform(100 * seed + static_cast<std::uint64_t>(i)));
  std::sort(angles.begin(), angles.end());
  const dvec2 center(rng.uniform(100 * seed + 50), rng.uniform(100 * seed + 51));
  const double radius = 0.2 + 0.5 * rng.uniform(100 * seed + 52);
  FlatPolygon polygon;
  polygon.count = count;
  for (std::size_t i = 0; i < angles.size(); ++i)
    polygon.x[i] = center + radius * dvec2(std::cos(angles[i]), std::sin(angles[i]));
  return polygon;
}

TEST(PlanarDifference, ConservesArea) {
  const CounterRng rng(3);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const FlatPolygon piece = random_polygon(rng, 2 * i, 3 + static_cast<int>(i % 6));
    const FlatPolygon hole = random_polygon(rng, 2 * i + 1, 3 + static_cast<int>(i % 5));
    const double shared = shared_area(piece, hole);
    EXPECT_NEAR(shared, shared_area(hole, piece), 1e-14);
    std::vector<FlatPolygon> rest{piece}, scratch;
    subtract(hole, 1e-15, rest, scratch);
    for (const FlatPolygon& part : rest) EXPECT_LE(part.count, FlatPolygon::kMaxStored);
    EXPECT_NEAR(area_of(rest), piece.area() - shared, 1e-13) << i;
  }
}

/// Several holes, some of which overlap: each point is in exactly one part, unless the point is in a hole.
TEST(PlanarDifference, PutsEachPointOutsideTheHolesIntoOnePart) {
  const CounterRng rng(4), points(5);
  for (std::uint64_t i = 0; i < 50; ++i) {
    const FlatPolygon piece = random_polygon(rng, 10 * i, 3);
    std::vector<FlatPolygon> holes, rest{piece}, scratch;
    for (std::uint64_t k = 1; k < 6; ++k) holes.push_back(random_polygon(rng, 10 * i + k, 4));
    for (const FlatPolygon& hole : holes) subtract(hole, 1e-15, rest, scratch);
    for (std::uint64_t k = 0; k < 200; ++k) {
      const dvec2 p(2 * points.uniform(1000 * i + 2 * k) - 0.5, 2 * points.uniform(1000 * i + 2 * k + 1) - 0.5);
      bool free = contains(piece, p);
      for (const FlatPolygon& hole : holes) free = free && !contains(hole, p);
      int parts = 0;
      for (const FlatPolygon& part : rest) parts += contains(part, p) ? 1 : 0;
      EXPECT_EQ(parts, free ? 1 : 0) << i;
    }
  }
}

}  // namespace
}  // namespace taxel
