// Slices of a tet by planes in all positions.
#include "core/hydro/kernel/slice_tet.h"

#include <gtest/gtest.h>

#include "fixtures/slab_field.h"

namespace taxel {
namespace {

double area(const TetSlice& slice, const dvec3& n) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(slice.count); ++i)
    sum += 0.5 * glm::dot(n, glm::cross(slice.points[i] - slice.points[0], slice.points[i + 1] - slice.points[0]));
  return sum;
}

TEST(SliceTet, GivesPolygonsCounterclockwiseAboutTheGradient) {
  const std::array<dvec3, 4> corners{dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
  for (int signs = 0; signs < 16; ++signs) {
    std::array<double, 4> d{};
    for (int i = 0; i < 4; ++i) d[static_cast<std::size_t>(i)] = (signs >> i & 1) ? 0.3 + 0.1 * i : -0.4 - 0.05 * i;
    const dvec3 gradient(d[1] - d[0], d[2] - d[0], d[3] - d[0]);
    TetSlice polygon;
    slice_tet(corners, {0, 1, 2, 3}, d, polygon);
    if (signs == 0 || signs == 15) {
      EXPECT_EQ(polygon.count, 0);
      continue;
    }
    ASSERT_GE(polygon.count, 3) << signs;
    const auto count = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(d[0] + glm::dot(gradient, polygon.points[i]), 0, 1e-15) << signs;
      const dvec3 a = polygon.points[i], b = polygon.points[(i + 1) % count];
      const dvec3 c = polygon.points[(i + 2) % count];
      EXPECT_GT(glm::dot(glm::cross(b - a, c - b), gradient), 0) << signs;  // convex and counterclockwise
      // Both ends of the edge are on the face: face 0 is x + y + z = 1, face k the plane k.
      const int face = polygon.face[i];
      for (const dvec3& p : {a, b}) EXPECT_NEAR(face == 0 ? p.x + p.y + p.z - 1 : p[face - 1], 0, 1e-15) << signs;
    }
  }
}

TEST(SliceTet, CountsASliceThroughSharedFacesOnce) {
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
    TetSlice polygon;
    slice_tet(corners, tet.vertices, d, polygon);
    sum += area(polygon, dvec3(0, 0, 1));
  }
  EXPECT_NEAR(sum, 4.0, 1e-14);
}

}  // namespace
}  // namespace taxel
