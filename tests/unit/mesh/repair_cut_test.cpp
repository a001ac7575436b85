// Crossing faces are cut out of a shell before the shell is wrapped, and wraps stay cheap and independent of the unit.
#include <gtest/gtest.h>

#include "core/mesh/query/self_intersection.h"
#include "core/mesh/repair/repair.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

/// A ball with pairs of spikes of which one goes through the other.
TriMesh folded_ball(int folds) {
  const TriMesh ball = make_icosphere(0.01, 4);
  std::vector<dvec3> vertices = ball.vertices();
  for (int i = 0; i < folds; ++i) {
    const int a = 100 + 300 * i;
    int b = 0;  // two edges away from a
    while (std::abs(glm::distance(ball.vertices()[test::slot(a)], ball.vertices()[test::slot(b)]) - 1.3e-3) > 0.2e-3)
      ++b;
    dvec3 &at_a = vertices[test::slot(a)], &at_b = vertices[test::slot(b)];
    const dvec3 out = glm::normalize(at_a), toward = glm::normalize(at_a - at_b);
    at_b = at_a + 0.4e-3 * out + 0.7e-3 * toward;
    at_a += 0.8e-3 * out;
  }
  return {std::move(vertices), ball.faces()};
}

RepairedMeshPtr cured(const TriMesh& mesh) {
  return repair_mesh(std::make_shared<const TriMesh>(mesh), {}, 0);
}

TriMesh scaled(const TriMesh& mesh, double factor) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v *= factor;
  return {std::move(vertices), mesh.faces()};
}

/// The top of a ball, pushed out through its bottom.
TriMesh ball_through_itself() {
  const TriMesh ball = make_icosphere(0.01, 4);
  std::vector<dvec3> vertices = ball.vertices();
  for (dvec3& v : vertices)
    if (v.z > 0.008) v += dvec3(0.00037, 0.00021, -0.0185);
  return {std::move(vertices), ball.faces()};
}

/// `count` triangles in all directions, most of which cross others.
TriMesh soup_of_triangles(int count) {
  test::RandomStream random(11);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int i = 0; i < count; ++i) {
    const dvec3 center = random.in_cube(0.02);
    for (int c = 0; c < 3; ++c) vertices.push_back(center + random.in_cube(0.008));
    faces.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return {std::move(vertices), std::move(faces)};
}

TEST(RepairCut, CutsFoldsOutAndKeepsAllOtherFaces) {
  const TriMesh folded = folded_ball(8);
  ASSERT_GT(find_self_intersections(folded).pairs, 5);
  const RepairedMeshPtr repaired = cured(folded);
  EXPECT_TRUE(repaired->mesh->closed());
  EXPECT_EQ(find_self_intersections(*repaired->mesh).pairs, 0);
  EXPECT_EQ(repaired->report.level, RepairLevel::exact);
  ASSERT_FALSE(repaired->report.steps.empty());
  EXPECT_EQ(repaired->report.steps[0].code, "repair_cut");
  int kept = 0;
  for (int f = 0; f < repaired->mesh->face_count(); ++f) {
    const int from = repaired->loaded_face(f);
    if (from < 0) continue;
    ++kept;
    for (int c = 0; c < 3; ++c) EXPECT_EQ(repaired->mesh->vertex(f, c), folded.vertex(from, c));
  }
  EXPECT_GT(kept, 0.95 * folded.face_count());
  EXPECT_NEAR(repaired->mesh->volume(), make_icosphere(0.01, 4).volume(), 1e-3 * repaired->mesh->volume());
}

TEST(RepairCut, WrapsAShellThatNoCutCures) {
  const RepairedMeshPtr repaired = cured(ball_through_itself());
  EXPECT_TRUE(repaired->mesh->closed());
  EXPECT_EQ(repaired->report.level, RepairLevel::wrap);
  EXPECT_EQ(find_self_intersections(*repaired->mesh).pairs, 0);
}

TEST(RepairCut, WrapsOnlyTheShellThatNeedsIt) {
  const TriMesh ball = test::moved(make_icosphere(0.01, 3), dvec3(0.05, 0, 0));
  const RepairedMeshPtr repaired = cured(test::together(ball_through_itself(), ball));
  EXPECT_EQ(repaired->report.level, RepairLevel::wrap);
  int kept = 0;
  for (const dvec3& v : repaired->mesh->vertices()) kept += v.x > 0.035 ? 1 : 0;
  EXPECT_EQ(kept, ball.vertex_count());
}

TEST(RepairCut, DoesNotDependOnTheUnit) {
  for (const TriMesh& mesh : {folded_ball(8), ball_through_itself()}) {
    const RepairedMeshPtr in_m = cured(mesh), in_mm = cured(scaled(mesh, 1000));
    EXPECT_EQ(in_m->mesh->face_count(), in_mm->mesh->face_count());
    EXPECT_NEAR(1e-9 * in_mm->mesh->volume(), in_m->mesh->volume(), 1e-6 * in_m->mesh->volume());
    EXPECT_NEAR(1e-6 * in_mm->mesh->area(), in_m->mesh->area(), 1e-6 * in_m->mesh->area());
  }
}

TEST(RepairCut, ClosesASoupOfCrossingTriangles) {
  const TriMesh soup = soup_of_triangles(200);
  const RepairedMeshPtr repaired = cured(soup);
  EXPECT_TRUE(repaired->mesh->closed());
  const int before = find_self_intersections(soup).pairs;
  EXPECT_LE(find_self_intersections(*repaired->mesh).pairs, std::min(before, repaired->mesh->face_count() / 1000));
}

}  // namespace
}  // namespace taxel
