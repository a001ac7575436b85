#include "core/hydro/clip.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

double area(const ClippedPolygon& polygon, const dvec3& n) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.count; ++i)
    sum +=
        0.5 * glm::dot(n, glm::cross(polygon.points[i] - polygon.points[0], polygon.points[i + 1] - polygon.points[0]));
  return sum;
}

/// One cell of a slab: six tets that fill the box [-1, 1]^2 x [-1, 0].
const PressureField& cube() {
  static const PressureFieldPtr field = make_slab_field(dvec2(1), 1, ivec3(1), 1);
  return *field;
}

double clipped_area(const Triangle& triangle) {
  const dvec3 n = glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  double sum = 0;
  ClippedPolygon polygon;
  for (int t = 0; t < static_cast<int>(cube().tets().size()); ++t) {
    clip_triangle(triangle, cube().tets()[static_cast<std::size_t>(t)], t, polygon);
    const double part = area(polygon, n);
    EXPECT_GE(part, -1e-15);
    sum += part;
  }
  return sum;
}

TEST(Clip, TetsShareATriangleWithoutLossOrOverlap) {
  const CounterRng rng(3);
  std::uint64_t k = 0;
  for (int i = 0; i < 200; ++i) {
    Triangle triangle;
    for (dvec3& v : triangle) {
      v.x = 2 * rng.uniform(k++) - 1;
      v.y = 2 * rng.uniform(k++) - 1;
      v.z = -rng.uniform(k++);
    }
    const double whole = 0.5 * glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    EXPECT_NEAR(clipped_area(triangle), whole, 1e-13);
  }
}

TEST(Clip, ATriangleInASharedPlaneIsCountedOnce) {
  // x = y is a plane between the tets of the cell.
  EXPECT_NEAR(clipped_area({dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)}), std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(clipped_area({dvec3(-0.5, -0.5, -0.9), dvec3(0.3, 0.3, -0.8), dvec3(0.1, 0.1, -0.2)}),
              0.5 * std::sqrt(2.0) * (0.8 * 0.7 - 0.6 * 0.1), 1e-14);
}

TEST(Clip, TheLowerTetHoldsASharedPlane) {
  const Triangle diagonal{dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)};
  ClippedPolygon polygon;
  for (int t = 0; t < 6; ++t) {
    const Tet& tet = cube().tets()[static_cast<std::size_t>(t)];
    clip_triangle(diagonal, tet, t, polygon);
    if (polygon.count == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const dvec3& n = tet.normal[static_cast<std::size_t>(i)];
      const bool in_plane = std::abs(n.x + n.y) + std::abs(n.z) < 1e-14;  // x = y
      EXPECT_TRUE(!in_plane || tet.neighbour[i] > t);
    }
  }
}

TEST(Clip, ATriangleARoundingAwayFromASharedPlaneIsCountedOnce) {
  for (const double noise : {1e-17, 1e-16, 3e-16, 1e-15, 1e-12}) {
    for (int corner = 0; corner < 6; ++corner) {
      Triangle triangle{dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)};
      triangle[static_cast<std::size_t>(corner / 2)].x +=
          (corner % 2 == 0 ? 1 : -1) * noise;  // the triangle's own area moves as much
      EXPECT_NEAR(clipped_area(triangle), std::sqrt(2.0), 1e-13 + noise) << noise << " " << corner;
    }
  }
}

TEST(Clip, ATriangleInTheBoundaryIsInside) {
  EXPECT_NEAR(clipped_area({dvec3(-1, -1, 0), dvec3(1, -1, 0), dvec3(0, 1, 0)}), 2.0, 1e-14);
}

TEST(Clip, OutsideAndTouchingTrianglesGiveNothing) {
  ClippedPolygon polygon;
  const Tet& tet = cube().tets()[0];
  clip_triangle({dvec3(-1, -1, 1), dvec3(1, -1, 1), dvec3(0, 1, 1)}, tet, 0, polygon);
  EXPECT_EQ(polygon.count, 0u);
  clip_triangle({dvec3(-1, -1, 0), dvec3(-1, -1, 1), dvec3(1, 1, 1)}, tet, 0, polygon);  // a corner touches
  EXPECT_EQ(polygon.count, 0u);
}

TEST(Clip, SlicesTurnAboutGrowingDistance) {
  const std::array<dvec3, 4> corners{dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
  for (int signs = 0; signs < 16; ++signs) {
    std::array<double, 4> d{};
    for (int i = 0; i < 4; ++i) d[static_cast<std::size_t>(i)] = (signs >> i & 1) ? 0.3 + 0.1 * i : -0.4 - 0.05 * i;
    const dvec3 gradient(d[1] - d[0], d[2] - d[0], d[3] - d[0]);
    ClippedPolygon polygon;
    slice_tet(corners, {0, 1, 2, 3}, d, polygon);
    if (signs == 0 || signs == 15) {
      EXPECT_EQ(polygon.count, 0u);
      continue;
    }
    ASSERT_GE(polygon.count, 3u) << signs;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      EXPECT_NEAR(d[0] + glm::dot(gradient, polygon.points[i]), 0, 1e-15) << signs;
      const dvec3 a = polygon.points[i], b = polygon.points[(i + 1) % polygon.count];
      const dvec3 c = polygon.points[(i + 2) % polygon.count];
      EXPECT_GT(glm::dot(glm::cross(b - a, c - b), gradient), 0) << signs;  // convex, and the right way round
    }
  }
}

TEST(Clip, SlicesThroughSharedFacesAreCountedOnce) {
  // The plane z = -0.5 of a slab of two layers is a plane of tets; n points up.
  const PressureFieldPtr slab = make_slab_field(dvec2(1), 1, ivec3(2), 1);
  double sum = 0;
  for (const Tet& tet : slab->tets()) {
    std::array<dvec3, 4> corners;
    std::array<double, 4> d{};
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i] = slab->vertices()[static_cast<std::size_t>(tet.vertices[static_cast<int>(i)])];
      d[i] = corners[i].z + 0.5;
    }
    ClippedPolygon polygon;
    slice_tet(corners, tet.vertices, d, polygon);
    sum += area(polygon, dvec3(0, 0, 1));
  }
  EXPECT_NEAR(sum, 4.0, 1e-14);
}

TEST(Clip, KeepsThePartBelowAPlane) {
  ClippedPolygon polygon;
  clip_triangle_by_plane({dvec3(0, 0, -1), dvec3(1, 0, -1), dvec3(0, 1, 1)}, {-1, -1, 1}, polygon);
  ASSERT_EQ(polygon.count, 4u);
  EXPECT_NEAR(glm::length(glm::cross(dvec3(1, 0, 0), dvec3(0, 1, 2))) / 2 * 0.75,
              area(polygon, glm::normalize(dvec3(0, -2, 1))), 1e-15);
  clip_triangle_by_plane({dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0)}, {0, 0, 0}, polygon);
  EXPECT_EQ(polygon.count, 0u);
}

}  // namespace
}  // namespace taxel
