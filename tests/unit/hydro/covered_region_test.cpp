// The part of a plane that a region leaves free: each point outside of the region is in exactly one part.
#include "core/hydro/kernel/covered_region.h"

#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/base/rng.h"
#include "fixtures/flat_polygons.h"

namespace taxel {
namespace {
using test::area_of;
using test::contains;

using Cover = CoveredRegion::Cover;

constexpr int kCells = 12;

/// Triangles of a square [0, 1]^2 with randomly moved grid points, of which a random part belongs to the region.
struct RandomRegion {
  std::vector<FlatPolygon> triangles;
  std::vector<std::uint32_t> ends;
  double area = 0;

  RandomRegion(std::uint64_t seed, double part) {
    const CounterRng rng(seed);
    const auto node = [&](int i, int j) {
      const auto n = static_cast<std::uint64_t>(2 * (i + (kCells + 1) * j));
      return (dvec2(i, j) + 0.3 * (dvec2(rng.uniform(n), rng.uniform(n + 1)) - 0.5)) / double{kCells};
    };
    // Triangle 0 of a cell is below its diagonal, triangle 1 above it.
    const auto covered = [&](int i, int j, int half) {
      if (i < 0 || j < 0 || i >= kCells || j >= kCells) return false;
      return rng.uniform(static_cast<std::uint64_t>(100000 + 2 * (i + kCells * j) + half)) < part;
    };
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const bool below = covered(i, j, 0), above = covered(i, j, 1);
        if (below) {
          add({node(i, j), node(i + 1, j), node(i + 1, j + 1)}, {!covered(i, j - 1, 1), !covered(i + 1, j, 1), !above});
        }
        if (above) {
          add({node(i, j), node(i + 1, j + 1), node(i, j + 1)}, {!below, !covered(i, j + 1, 0), !covered(i - 1, j, 0)});
        }
      }
    }
  }

  void add(const std::array<dvec2, 3>& corners, const std::array<bool, 3>& is_end) {
    FlatPolygon& triangle = triangles.emplace_back();
    triangle.count = 3;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.x[k] = corners[k];
      bits |= is_end[k] ? 1u << k : 0u;
    }
    ends.push_back(bits);
    area += triangle.area();
  }

  [[nodiscard]] bool holds(const dvec2& p) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](const FlatPolygon& t) { return contains(t, p); });
  }
  /// Returns the area of the region in a piece, by brute force.
  [[nodiscard]] double area_in(const FlatPolygon& piece) const {
    double sum = 0;
    for (const FlatPolygon& t : triangles) sum += shared_area(piece, t);
    return sum;
  }
  CoveredRegion::List put_into(CoveredRegion& covered, std::uint32_t skin = 0) const {
    covered.clear();
    for (std::size_t i = 0; i < triangles.size(); ++i) covered.add(triangles[i], {ends[i], skin & ends[i]});
    return covered.list_all();
  }
};

FlatPolygon random_triangle(const CounterRng& rng, std::uint64_t n, double size) {
  const dvec2 center(rng.uniform(10 * n), rng.uniform(10 * n + 1));
  const double turn = 2 * kPi * rng.uniform(10 * n + 2);
  FlatPolygon triangle;
  triangle.count = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = turn + 2 * kPi / 3 * static_cast<double>(k);
    triangle.x[k] = center + size * dvec2(std::cos(angle), std::sin(angle));
  }
  return triangle;
}

TEST(CoveredRegion, LeavesTheAreaOfThePieceLessThatOfTheRegion) {
  CoveredRegion covered;
  const CounterRng rng(11);
  for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const RandomRegion region(static_cast<std::uint64_t>(1 + 10 * part), part);
    const CoveredRegion::List all = region.put_into(covered);
    for (std::uint64_t n = 0; n < 100; ++n) {
      const FlatPolygon piece = random_triangle(rng, n, n % 2 == 0 ? 0.05 : 0.4);
      const CoveredRegion::List near = covered.list_near(piece, all);
      std::vector<FlatPolygon> rest;
      covered.add_rest(piece, near, 1e-12, rest);
      const double free = piece.area() - region.area_in(piece);
      EXPECT_NEAR(area_of(rest), free, 1e-9 * piece.area()) << part << ' ' << n;
      EXPECT_EQ(covered.cover_of(piece, near) == Cover::whole, free < 1e-9 * piece.area()) << part << ' ' << n;
      for (const FlatPolygon& polygon : rest) EXPECT_LE(polygon.count, FlatPolygon::kMaxStored);
      covered.forget_lists(all.last);
    }
  }
}

TEST(CoveredRegion, PutsEachPointOutsideIntoOnePart) {
  CoveredRegion covered;
  const CounterRng rng(12), points(13);
  const RandomRegion region(3, 0.6);
  const CoveredRegion::List all = region.put_into(covered);
  for (std::uint64_t n = 0; n < 40; ++n) {
    const FlatPolygon piece = random_triangle(rng, n, 0.2);
    std::vector<FlatPolygon> rest;
    covered.add_rest(piece, covered.list_near(piece, all), 1e-12, rest);
    for (std::uint64_t k = 0; k < 300; ++k) {
      const dvec2 p =
          piece.x[0] + 0.4 * (dvec2(points.uniform(1000 * n + 2 * k), points.uniform(1000 * n + 2 * k + 1)) - 0.5);
      const auto parts = std::count_if(rest.begin(), rest.end(), [&](const FlatPolygon& r) { return contains(r, p); });
      EXPECT_EQ(parts, contains(piece, p) && !region.holds(p) ? 1 : 0) << n;
    }
    covered.forget_lists(all.last);
  }
}

/// Returns the length of the part of a segment that is inside of a convex polygon.
double length_inside(const FlatPolygon& polygon, const dvec2& a, const dvec2& b) {
  double from = 0, to = 1;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2 &c = polygon.x[at(i)], side = polygon.x[at((i + 1) % polygon.count)] - c;
    const double at_a = cross_2d(side, a - c), slope = cross_2d(side, b - a);
    if (slope > 0) from = std::max(from, -at_a / slope);
    if (slope < 0) to = std::min(to, -at_a / slope);
    if (slope == 0 && at_a < 0) return 0;
  }
  return std::max(0.0, to - from) * glm::distance(a, b);
}

TEST(CoveredRegion, SaysWhetherItEndsOnlyAtTheSkin) {
  CoveredRegion covered;
  const CounterRng rng(15);
  std::array<int, 4> found{};
  for (const double part : {0.5, 0.9, 1.0}) {
    const RandomRegion region(static_cast<std::uint64_t>(40 + 10 * part), part);
    for (const std::uint32_t skin : {0b000u, 0b011u, 0b111u}) {
      const CoveredRegion::List all = region.put_into(covered, skin);
      for (std::uint64_t n = 0; n < 100; ++n) {
        const FlatPolygon piece = random_triangle(rng, n, n % 2 == 0 ? 0.03 : 0.1);
        double at_skin = 0, inside = 0;
        for (std::size_t t = 0; t < region.triangles.size(); ++t) {
          const auto& x = region.triangles[t].x;
          for (std::size_t k = 0; k < 3; ++k) {
            if ((region.ends[t] >> k & 1u) != 0)
              ((skin >> k & 1u) != 0 ? at_skin : inside) += length_inside(piece, x[k], x[(k + 1) % 3]);
          }
        }
        const dvec2 middle = (piece.x[0] + piece.x[1] + piece.x[2]) / 3.0;
        const Cover expected = inside > 1e-9    ? Cover::part
                               : at_skin > 1e-9 ? Cover::up_to_skin
                                                : (region.holds(middle) ? Cover::whole : Cover::none);
        EXPECT_EQ(covered.cover_of(piece, covered.list_near(piece, all)), expected) << part << ' ' << skin << ' ' << n;
        ++found[static_cast<std::size_t>(expected)];
        covered.forget_lists(all.last);
      }
    }
  }
  for (const int count : found) EXPECT_GT(count, 20);
}

/// The rest of a convex hole is one polygon, however many polygons the region around it has.
TEST(CoveredRegion, FillsAConvexHoleByOnePart) {
  CoveredRegion covered;
  constexpr int kSides = 6;
  const auto on_circle = [](double radius, int i) {
    const double angle = 2 * kPi * i / kSides;
    return dvec2(radius * std::cos(angle), radius * std::sin(angle));
  };
  covered.clear();
  for (int i = 0; i < kSides; ++i) {
    FlatPolygon side;
    side.count = 4;
    side.x[0] = on_circle(1, i), side.x[1] = on_circle(3, i);
    side.x[2] = on_circle(3, i + 1), side.x[3] = on_circle(1, i + 1);
    covered.add(side, {1u << 3 | 1u << 1});
  }
  FlatPolygon piece;
  piece.count = 3;
  for (int i = 0; i < 3; ++i) piece.x[at(i)] = on_circle(2.2, 2 * i);
  std::vector<FlatPolygon> rest;
  covered.add_rest(piece, covered.list_all(), 1e-12, rest);
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_EQ(rest[0].count, kSides);
  EXPECT_NEAR(rest[0].area(), 0.5 * kSides * std::sin(2 * kPi / kSides), 1e-12);
}

/// A sliver that was left out between two polygons is not an end of the region: a piece whose middle is in the gap is
/// covered but for the gap.
TEST(CoveredRegion, CoversAPieceWhoseMiddleIsInAGap) {
  for (const double gap : {0.0, 1e-16, 1e-7}) {
    CoveredRegion covered;
    covered.clear();
    for (const double side : {-1.0, 1.0}) {
      FlatPolygon half;
      half.count = 4;
      const double lo = side < 0 ? -1 : 0.5 * gap, hi = side < 0 ? -0.5 * gap : 1;
      half.x[0] = {lo, -1}, half.x[1] = {hi, -1}, half.x[2] = {hi, 1}, half.x[3] = {lo, 1};
      covered.add(half, {side < 0 ? 0b1101u : 0b0111u});  // all edges but that at the gap
    }
    FlatPolygon piece;
    piece.count = 3;
    piece.x[0] = {-0.5, -0.5}, piece.x[1] = {0.5, -0.5}, piece.x[2] = {0, 0.5};
    const CoveredRegion::List near = covered.list_near(piece, covered.list_all());
    std::vector<FlatPolygon> rest;
    covered.add_rest(piece, near, 1e-15, rest);
    EXPECT_LE(area_of(rest), 1.01 * gap) << gap;
    if (gap < 1e-10) {
      EXPECT_EQ(covered.cover_of(piece, near), Cover::whole) << gap;
    }
  }
}

/// Two polygons that overlap have edges that are not ends of their union: the rest is still right.
TEST(CoveredRegion, LeavesTheRestOfPolygonsThatOverlap) {
  CoveredRegion covered;
  const CounterRng rng(14);
  for (std::uint64_t n = 0; n < 50; ++n) {
    const FlatPolygon piece = random_triangle(rng, 7 * n, 0.3);
    std::vector<FlatPolygon> holes, expected{piece}, scratch, rest;
    covered.clear();
    for (std::uint64_t k = 1; k < 5; ++k) {
      holes.push_back(random_triangle(rng, 7 * n + k, 0.3));
      covered.add(holes.back(), {0b111});
      subtract(holes.back(), 1e-12, expected, scratch);
    }
    covered.add_rest(piece, covered.list_all(), 1e-12, rest);
    EXPECT_NEAR(area_of(rest), area_of(expected), 1e-4 * piece.area()) << n;
  }
}

}  // namespace
}  // namespace taxel
