// Wraps: faces that no exact step turns into a solid get a new surface around them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "core/mesh/query/self_intersection.h"
#include "core/mesh/repair/repair.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

constexpr double kThickness = 0.002;

RepairRecipe coarse(RepairLevel level = RepairLevel::automatic) {
  RepairRecipe recipe;
  recipe.level = level;
  recipe.edge = 0.5e-3;
  return recipe;
}

RepairedMesh wrapped(const TriMesh& mesh, const RepairRecipe& recipe = coarse()) {
  return *repair_mesh(std::make_shared<const TriMesh>(mesh), recipe, kThickness);
}

/// Expects a closed wrap with a warning. A second repair must not change it.
void expect_wrapped(const RepairedMesh& repaired, const TriMesh& loaded) {
  EXPECT_TRUE(repaired.mesh->closed());
  EXPECT_EQ(repaired.report.level, RepairLevel::wrap);
  ASSERT_FALSE(repaired.report.steps.empty());
  EXPECT_EQ(repaired.report.steps[0].severity, Severity::warning);
  EXPECT_EQ(repaired.changes.distance.size(), repaired.mesh->vertices().size());
  ASSERT_EQ(repaired.loaded_face_of.size(), repaired.mesh->faces().size());
  for (const int face : repaired.loaded_face_of) {
    EXPECT_GE(face, 0);
    EXPECT_LT(face, loaded.face_count());
  }
  EXPECT_EQ(repair_mesh(repaired.mesh, coarse(), kThickness)->mesh, repaired.mesh);
}

/// A figure of eight that is turned over once while it goes around: a Klein bottle of n x 2n points.
TriMesh klein_bottle(int n, double size) {
  std::vector<dvec3> points;
  std::vector<ivec3> faces;
  for (int i = 0; i < 2 * n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = kPi * i / n, v = 2 * kPi * j / n;
      const double in = std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      const double up = std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
      points.push_back(size * dvec3((1 + 0.4 * in) * std::cos(u), (1 + 0.4 * in) * std::sin(u), 0.4 * up));
      const int next = i + 1 < 2 * n ? i + 1 : 0, above = (j + 1) % n;
      faces.emplace_back(i * n + j, next * n + j, next * n + above);
      faces.emplace_back(i * n + j, next * n + above, i * n + above);
    }
  }
  return {points, faces};
}

TEST(RepairWrap, DoesNotDependOnTheUnit) {
  const auto repaired = [](double unit) {
    return repair_mesh(std::make_shared<const TriMesh>(klein_bottle(30, 0.02 * unit)), {}, kThickness * unit);
  };
  const RepairedMeshPtr metres = repaired(1);
  EXPECT_EQ(metres->report.level, RepairLevel::wrap);
  for (const double unit : {0.001, 0.0254, 0.7, 3.0, 1000.0}) {
    const RepairedMeshPtr other = repaired(unit);
    ASSERT_EQ(metres->mesh->faces(), other->mesh->faces()) << unit;
    for (std::size_t v = 0; v < metres->mesh->vertices().size(); ++v)
      EXPECT_LT(glm::distance(metres->mesh->vertices()[v], other->mesh->vertices()[v] / unit), 1e-12) << unit;
  }
}

TEST(RepairWrap, StaysNearASphere) {
  const TriMesh sphere = make_icosphere(0.008, 4);
  const RepairedMesh repaired = wrapped(sphere, coarse(RepairLevel::wrap));
  expect_wrapped(repaired, sphere);
  EXPECT_NEAR(repaired.mesh->volume(), sphere.volume(), 0.02 * sphere.volume());
  EXPECT_LT(repaired.report.distance_max, 1e-3);  // two edges
  EXPECT_LT(repaired.report.distance_rms, 0.1e-3);
  EXPECT_GT(repaired.report.distance_rms, 0);
  const std::vector<float>& distances = repaired.changes.distance;
  EXPECT_FLOAT_EQ(*std::max_element(distances.begin(), distances.end()),
                  static_cast<float>(repaired.report.distance_max))
      << "the scale of the colours ends at the distance that is reported";
}

TEST(RepairWrap, MakesASheetIntoABodyOfThePadsThickness) {
  const TriMesh box = test::refined_box(0.008, 6);
  std::vector<int> others;
  for (int f = 0; f < box.face_count(); ++f)
    if (box.face_normals()[test::slot(f)].z < 0.9) others.push_back(f);
  const TriMesh sheet =
      extract_faces(test::without_faces(box, others), test::all_faces(test::without_faces(box, others)));
  const RepairedMesh repaired = wrapped(sheet);
  expect_wrapped(repaired, sheet);
  EXPECT_EQ(repaired.report.steps[0].code, "repair_sheet");
  for (std::size_t i = 1; i < repaired.report.steps.size(); ++i)  // the simplified surface may need exact steps
    EXPECT_EQ(repaired.report.steps[i].severity, Severity::note) << repaired.report.steps[i].message;
  // 16 x 16 x 2 mm below z = 8 mm.
  EXPECT_NEAR(repaired.mesh->volume(), 512e-9, 0.02 * 512e-9);
  EXPECT_NEAR(repaired.mesh->bounds().hi.z, 0.008, 1e-5);
  EXPECT_NEAR(repaired.mesh->bounds().lo.z, 0.006, 1e-4);
}

TEST(RepairWrap, MakesOneTriangleIntoABody) {
  const TriMesh triangle({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}});
  const RepairedMesh repaired = wrapped(triangle);
  expect_wrapped(repaired, triangle);
  EXPECT_NEAR(repaired.mesh->volume(), 100e-9, 0.03 * 100e-9);
}

TEST(RepairWrap, WrapsAMoebiusStrip) {
  const TriMesh strip = test::moebius_strip(0.01, 0.003, 40);
  const RepairedMesh repaired = wrapped(strip);
  expect_wrapped(repaired, strip);
  EXPECT_EQ(repaired.report.steps[0].code, "repair_sheet");
  EXPECT_NEAR(repaired.mesh->volume(), strip.area() * kThickness, 0.1 * strip.area() * kThickness);
}

TEST(RepairWrap, WrapsASurfaceThatCutsThroughItself) {
  // The top of a ball is pushed out through its bottom.
  const TriMesh ball = make_icosphere(0.01, 4);
  std::vector<dvec3> vertices = ball.vertices();
  for (dvec3& v : vertices)
    if (v.z > 0.008) v += dvec3(0.00037, 0.00021, -0.0185);
  const TriMesh crossed(vertices, ball.faces());
  ASSERT_GT(find_self_intersections(crossed).pairs, 100);
  const RepairedMesh repaired = wrapped(crossed);
  expect_wrapped(repaired, crossed);
  EXPECT_EQ(repaired.report.steps[0].code, "repair_wrapped");
}

TEST(RepairWrap, IsRefusedAtTheLevelExact) {
  try {
    wrapped(test::moebius_strip(0.01, 0.003, 40), coarse(RepairLevel::exact));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/mesh/repair/level");
    EXPECT_NE(error.message().find("("), std::string::npos) << error.message();  // the message contains the place
  }
}

TEST(RepairWrap, AsksForALargerEdgeIfTheLatticeIsTooLarge) {
  RepairRecipe recipe = coarse(RepairLevel::wrap);
  recipe.edge = 1e-6;
  try {
    wrapped(make_icosphere(0.01, 1), recipe);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/mesh/repair/edge");
  }
}

TEST(RepairWrap, IsCoarserForAMeshOfManyFaces) {
  RepairRecipe recipe;
  recipe.level = RepairLevel::wrap;
  for (const int level : {4, 6}) {  // 5120 and 81920 faces
    const TriMesh ball = make_icosphere(0.01, level);
    const double squares = level == 4 ? 10000 : 10000 * std::sqrt(20000.0 / 81920);
    const RepairedMesh repaired = wrapped(ball, recipe);
    EXPECT_TRUE(repaired.report.is_coarser);
    EXPECT_NEAR(repaired.report.wrap_edge, std::sqrt(ball.area() / squares), 1e-9 * repaired.report.wrap_edge);
  }
}

TEST(RepairWrap, NamesItsStepsAndReportsGrowingProgress) {
  Progress progress;
  std::vector<double> fractions;
  std::jthread watcher([&](const std::stop_token& done) {
    while (!done.stop_requested()) fractions.push_back(progress.fraction());
  });
  const auto ball = std::make_shared<const TriMesh>(make_icosphere(0.01, 5));
  repair_mesh(ball, coarse(RepairLevel::wrap), kThickness, &progress);
  watcher.request_stop();
  watcher.join();
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_STREQ(progress.step(), "Measuring the wrap");
  EXPECT_EQ(progress.fraction(), 0.9) << "where the last step began";
}

TEST(RepairWrap, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  const auto ball = std::make_shared<const TriMesh>(make_icosphere(0.01, 2));
  EXPECT_THROW(repair_mesh(ball, coarse(RepairLevel::wrap), kThickness, &progress), Cancelled);
}

}  // namespace
}  // namespace taxel
