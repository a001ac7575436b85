// Cuts of meshes with planes: closed loops with the right area.
#include "core/mesh/tri_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using Segments = std::vector<std::pair<dvec3, dvec3>>;

/// Returns the area enclosed by the segments, counter-clockwise about the normal: the sum of a x b / 2.
double enclosed_area(const Segments& segments, const dvec3& point, const dvec3& normal) {
  dvec3 sum{0};
  for (const auto& [a, b] : segments) sum += 0.5 * glm::cross(a - point, b - point);
  return glm::dot(sum, glm::normalize(normal));
}

/// Expects every end of a segment to be the beginning of exactly one other segment, bit by bit.
void expect_closed_loops(const Segments& segments) {
  std::map<std::tuple<double, double, double>, int> balance;
  for (const auto& [a, b] : segments) {
    ++balance[{a.x, a.y, a.z}];
    --balance[{b.x, b.y, b.z}];
  }
  for (const auto& [point, count] : balance) EXPECT_EQ(count, 0);
}

TEST(Slice, GivesTheCrossSectionOfABox) {
  const TriMesh box = make_box({1, 2, 3});
  const Segments cut = slice_mesh(box, {0, 0, 0.5}, {0, 0, 1});
  EXPECT_EQ(cut.size(), 8U);
  expect_closed_loops(cut);
  EXPECT_NEAR(enclosed_area(cut, {0, 0, 0.5}, {0, 0, 1}), 8, 1e-12) << "the body lies on the left";
  EXPECT_NEAR(enclosed_area(slice_mesh(box, {0, 0, 0.5}, {0, 0, -2}), {0, 0, 0.5}, {0, 0, -1}), 8, 1e-12);
  for (const auto& [a, b] : cut) {
    EXPECT_EQ(a.z, 0.5);
    EXPECT_EQ(b.z, 0.5);
  }
}

TEST(Slice, GivesClosedLoopsThroughVerticesAndFaces) {
  const TriMesh box = make_box({1, 2, 3});
  expect_closed_loops(slice_mesh(box, {0, 0, 3}, {0, 0, 1}));
  expect_closed_loops(slice_mesh(box, {0, 0, -3}, {0, 0, 1}));
  EXPECT_NEAR(enclosed_area(slice_mesh(box, {0, 0, 3}, {0, 0, 1}), {0, 0, 3}, {0, 0, 1}), 8, 1e-12);
  const Segments diagonal = slice_mesh(box, {1, 2, 3}, {2, -1, 0});
  expect_closed_loops(diagonal);
  EXPECT_NEAR(enclosed_area(diagonal, {1, 2, 3}, {2, -1, 0}), 6 * 2 * std::sqrt(5.0), 1e-12);
}

TEST(Slice, GivesCirclesForASphere) {
  const TriMesh sphere = make_icosphere(1, 5);
  test::RandomStream random(1);
  for (int i = 0; i < 50; ++i) {
    const dvec3 normal = random.direction();
    const double height = random.uniform(-0.9, 0.9);
    const Segments cut = slice_mesh(sphere, height * normal, 3.0 * normal);
    expect_closed_loops(cut);
    EXPECT_NEAR(enclosed_area(cut, height * normal, normal) / (kPi * (1 - height * height)), 1, 5e-3);
    for (const auto& [a, b] : cut) EXPECT_NEAR(glm::dot(a, normal), height, 1e-12);
  }
}

TEST(Slice, HasAreasThatAddUpToTheVolume) {
  const TriMesh body = test::bumpy_sphere(4);
  const dvec3 normal = glm::normalize(dvec3(1, 2, 3));
  double volume = 0;
  constexpr int kSlices = 400;
  for (int i = 0; i < kSlices; ++i) {
    const dvec3 point = normal * (-1.5 + 3.0 * (i + 0.5) / kSlices);
    volume += enclosed_area(slice_mesh(body, point, normal), point, normal) * 3.0 / kSlices;
  }
  EXPECT_NEAR(volume / body.volume(), 1, 1e-4);
}

TEST(Slice, IsEmptyOutsideTheMesh) {
  EXPECT_TRUE(slice_mesh(make_icosphere(1, 2), {0, 0, 1.1}, {0, 0, 1}).empty());
}

}  // namespace
}  // namespace taxel
