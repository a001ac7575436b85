// The problems that check_mesh finds, and the repairs that need no decision.
#include "core/mesh/topology/mesh_check.h"

#include <gtest/gtest.h>

#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::moved;
using test::together;

std::vector<std::string> codes(const TriMesh& mesh) {
  std::vector<std::string> found;
  for (const Problem& problem : check_mesh(mesh, "finger.obj")) {
    EXPECT_EQ(problem.file, "finger.obj");
    EXPECT_FALSE(problem.message.empty());
    found.push_back(problem.code);
  }
  return found;
}
using Codes = std::vector<std::string>;

TriMesh without_face(const TriMesh& mesh, int face) {
  std::vector<ivec3> faces = mesh.faces();
  faces.erase(faces.begin() + face);
  return {mesh.vertices(), std::move(faces)};
}

TriMesh with_turned_faces(const TriMesh& mesh, const std::vector<int>& turned) {
  std::vector<ivec3> faces = mesh.faces();
  for (const int f : turned) std::swap(faces[static_cast<std::size_t>(f)].x, faces[static_cast<std::size_t>(f)].y);
  return {mesh.vertices(), std::move(faces)};
}

TEST(MeshCheck, FindsNoProblemsInASoundMesh) {
  EXPECT_EQ(codes(make_icosphere(0.01, 3)), Codes{});
  EXPECT_EQ(codes(make_fingertip()), Codes{});
}

TEST(MeshCheck, CountsAndLocatesOpenEdges) {
  const Problems problems = check_mesh(without_face(make_box(dvec3(0.1)), 0), "a.obj");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].code, "mesh_open");
  EXPECT_NE(problems[0].message.find("3 open edges"), std::string::npos) << problems[0].message;
}

TEST(MeshCheck, ReportsNonManifoldEdgesAndWindingAsErrors) {
  const TriMesh box = make_box(dvec3(0.1));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  vertices.emplace_back(0.3, 0.3, 0.3);
  faces.emplace_back(6, 7, 8);
  EXPECT_EQ(codes(TriMesh(vertices, faces)), (Codes{"mesh_open", "mesh_nonmanifold"}));
  EXPECT_EQ(codes(with_turned_faces(box, {4})), Codes{"mesh_winding"});
}

TEST(MeshCheck, ReportsInvertedMeshesCavitiesAndSeveralShells) {
  const TriMesh ball = make_icosphere(0.1, 2), small = make_box(dvec3(0.02));
  EXPECT_EQ(codes(flipped(ball)), Codes{"mesh_inverted"});
  EXPECT_EQ(codes(together(ball, flipped(small))), Codes{"mesh_cavity"});
  EXPECT_EQ(codes(together(flipped(small), ball)), Codes{"mesh_cavity"});
  EXPECT_EQ(codes(together(ball, moved(small, {0.5, 0, 0}))), Codes{"mesh_shells"});
}

TEST(MeshCheck, GuessesMillimetresFromTheSize) {
  EXPECT_EQ(codes(make_box({9, 8, 15})), Codes{"mesh_units"});
  EXPECT_EQ(guess_unit(make_box({9, 8, 15})).unit, "mm");
  EXPECT_EQ(guess_unit(make_box({9, 8, 15})).scale, 0.001);
  EXPECT_EQ(guess_unit(make_fingertip()).unit, "m");
}

TEST(Orient, WindsNeighboursAlikeAndClosedShellsOutward) {
  const TriMesh ball = make_icosphere(0.1, 2);
  const TriMesh mended = oriented(with_turned_faces(ball, {0, 3, 17, 100}));
  EXPECT_TRUE(mended.closed());
  EXPECT_DOUBLE_EQ(mended.volume(), ball.volume());
  EXPECT_DOUBLE_EQ(oriented(flipped(ball)).volume(), ball.volume());
  const TriMesh sound = oriented(ball);
  EXPECT_TRUE(sound.faces() == ball.faces()) << "a sound mesh is not changed";
}

TEST(Orient, TurnsCavitiesInward) {
  const TriMesh ball = make_icosphere(0.1, 2), cavity = make_box(dvec3(0.02));
  EXPECT_NEAR(oriented(together(ball, cavity)).volume(), ball.volume() - cavity.volume(), 1e-15);
  EXPECT_NEAR(oriented(together(flipped(ball), cavity)).volume(), ball.volume() - cavity.volume(), 1e-15);
}

TEST(Orient, LeavesASeamInAMoebiusStrip) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    const double a = 2 * kPi * i / kSteps;
    for (const double s : {-0.3, 0.3})
      vertices.emplace_back((1 + s * std::cos(a / 2)) * std::cos(a), (1 + s * std::cos(a / 2)) * std::sin(a),
                            s * std::sin(a / 2));
    const int low = 2 * i, high = 2 * i + 1;
    const int next_low = i + 1 < kSteps ? low + 2 : 1, next_high = i + 1 < kSteps ? high + 2 : 0;
    faces.emplace_back(low, next_low, high);
    faces.emplace_back(high, next_low, next_high);
  }
  const Codes found = codes(oriented(TriMesh(vertices, faces)));
  EXPECT_NE(std::find(found.begin(), found.end(), "mesh_winding"), found.end());
}

}  // namespace
}  // namespace taxel
