// Straight lines over a mesh and its unfolding, on surfaces that can be flattened by hand.
#include "core/layout/sampling/surface_walk.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

constexpr double kFold = 2.7;  // angle between the normals of the two sides of the strip [rad], more than a right angle

/// A strip of n x n squares, flat for x < 0 and folded down about the y axis for x > 0, with the flat place of each
/// point.
struct FoldedStrip {
  explicit FoldedStrip(int n) : size(n) {
    std::vector<dvec3> vertices;
    std::vector<ivec3> faces;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) vertices.push_back(folded(dvec2(2.0 * i / n - 1.0, 2.0 * j / n - 1.0)));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int a = i * (n + 1) + j, b = a + n + 1;
        faces.emplace_back(a, b, b + 1);
        faces.emplace_back(a, b + 1, a + 1);
      }
    mesh = std::make_unique<TriMesh>(std::move(vertices), std::move(faces));
  }
  static dvec3 folded(const dvec2& p) {
    return p.x < 0 ? dvec3(p.x, p.y, 0) : dvec3(p.x * std::cos(kFold), p.y, -p.x * std::sin(kFold));
  }
  [[nodiscard]] SurfaceStep place(const dvec2& p) const {
    const double u = 0.5 * size * (p.x + 1), v = 0.5 * size * (p.y + 1);
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    return {2 * (i * size + j) + (v - j > u - i ? 1 : 0), folded(p)};
  }
  int size;
  std::unique_ptr<TriMesh> mesh;
};

TEST(SurfaceWalk, KeepsLinesStraightOverAFold) {
  const FoldedStrip strip(6);
  const SurfaceGraph graph(*strip.mesh);
  const CounterRng rng(1);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const dvec2 from(-0.9 * rng.uniform(4 * k) - 0.01, 1.8 * rng.uniform(4 * k + 1) - 0.9);
    const dvec2 to(1.8 * rng.uniform(4 * k + 2) - 0.9, 1.8 * rng.uniform(4 * k + 3) - 0.9);
    const SurfaceStep end = graph.walk(strip.place(from), dvec3(to - from, 0.0));
    EXPECT_LT(glm::distance(end.position, FoldedStrip::folded(to)), 1e-12);
    EXPECT_EQ(end.face, strip.place(to).face);
  }
}

TEST(SurfaceWalk, StopsAtTheRim) {
  const FoldedStrip strip(3);
  const SurfaceGraph graph(*strip.mesh);
  const SurfaceStep end = graph.walk(strip.place(dvec2(-0.5, 0.1)), dvec3(0.3, 5.0, 0));
  EXPECT_NEAR(end.position.y, 1.0, 1e-12);
  EXPECT_NEAR(end.position.x, -0.5 + 0.3 * 0.9 / 5.0, 1e-12);
}

TEST(SurfaceWalk, GoesAroundABoxAndReturns) {
  const TriMesh box = make_box(dvec3(1.0, 2.0, 0.5));
  const SurfaceGraph graph(box);
  int top = 0;
  while (box.face_normals()[static_cast<std::size_t>(top)].z < 0.5) ++top;
  const dvec3 start = (box.vertex(top, 0) + box.vertex(top, 1) + box.vertex(top, 2)) / 3.0;
  const SurfaceStep end = graph.walk({top, start}, dvec3(6.0, 0, 0));  // 2 + 1 + 2 + 1
  EXPECT_LT(glm::distance(end.position, start), 1e-12);
  EXPECT_EQ(end.face, top);
}

TEST(SurfaceChart, UnfoldsAFold) {
  const FoldedStrip strip(8);
  const SurfaceGraph graph(*strip.mesh);
  SurfaceChart chart(graph);
  const CounterRng rng(2);
  for (std::uint64_t k = 0; k < 50; ++k) {
    const dvec2 from(-0.9 * rng.uniform(2 * k) - 0.01, 1.8 * rng.uniform(2 * k + 1) - 0.9);
    chart.unfold(strip.place(from), dvec3(1, 0, 0), dvec3(0, 1, 0), 0.8);
    for (std::uint64_t m = 0; m < 50; ++m) {
      const dvec2 to(1.8 * rng.uniform(5000 + 2 * m) - 0.9, 1.8 * rng.uniform(5001 + 2 * m) - 0.9);
      dvec2 flat(9.0);
      const bool found = chart.find(strip.place(to), flat);
      EXPECT_TRUE(found || glm::distance(from, to) >= 0.8);
      if (found) {
        EXPECT_LT(glm::distance(flat, to - from), 1e-12);
      }
    }
  }
}

TEST(SurfaceChart, MeasuresTheWayAroundToAnOppositeWall) {
  const TriMesh plate = make_box(dvec3(1.0, 1.0, 0.001));
  const SurfaceGraph graph(plate);
  SurfaceChart chart(graph);
  const auto on = [&](double side, const dvec2& p) {
    for (int f = 0; f < plate.face_count(); ++f) {
      const dvec3 x(p, side * 0.001), &a = plate.vertex(f, 0), &b = plate.vertex(f, 1), &c = plate.vertex(f, 2);
      const dvec3& n = plate.face_normals()[static_cast<std::size_t>(f)];
      if (n.z * side > 0.5 && glm::dot(glm::cross(b - a, x - a), n) >= 0 &&
          glm::dot(glm::cross(c - b, x - b), n) >= 0 && glm::dot(glm::cross(a - c, x - c), n) >= 0)
        return SurfaceStep{f, x};
    }
    return SurfaceStep{};
  };
  dvec2 flat;
  chart.unfold(on(1, dvec2(0.1, 0.2)), dvec3(1, 0, 0), dvec3(0, 1, 0), 0.5);
  EXPECT_FALSE(chart.find(on(-1, dvec2(0.1, 0.2)), flat));  // 0.002 through the wall, 1.6 around it
  chart.unfold(on(1, dvec2(0.9, 0.2)), dvec3(1, 0, 0), dvec3(0, 1, 0), 0.5);
  ASSERT_TRUE(chart.find(on(-1, dvec2(0.95, 0.1)), flat));
  EXPECT_NEAR(glm::length(flat), glm::length(dvec2(0.1 + 0.002 + 0.05, 0.1)), 1e-12);
}

}  // namespace
}  // namespace taxel
