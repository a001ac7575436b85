// Tip and pad of fingers, guessed from their shape.
#include "core/layout/sensor_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/remesh.h"

namespace taxel {
namespace {

TriMeshPtr own_finger() {
  return load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj").mesh;
}

TriMesh turned(const TriMesh& mesh, const dmat3& R) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v = R * v + dvec3(0.3, -0.1, 0.2);
  return TriMesh(std::move(vertices), mesh.faces());
}

TEST(FrameGuess, FollowsAFingerInAllOrientationsAlongAxes) {
  const TriMeshPtr finger = own_finger();
  int orientations = 0;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b) {
      if (a % 3 == b % 3) continue;
      dvec3 x(0), y(0);
      x[a % 3] = a < 3 ? 1 : -1, y[b % 3] = b < 3 ? 1 : -1;
      const dmat3 R(x, y, glm::cross(x, y));
      const std::optional<SensorFrame> guess = guess_frame(turned(*finger, R));
      ASSERT_TRUE(guess);
      EXPECT_EQ(guess->distal, R * dvec3(0, 0, 1));
      EXPECT_EQ(guess->pad, R * dvec3(0, -1, 0));
      ++orientations;
    }
  EXPECT_EQ(orientations, 24);
}

TEST(FrameGuess, IsTheSameForAFineMesh) {
  const TriMesh fine = subdivide(*own_finger(), 4, SubdivisionScheme::midpoint);
  ASSERT_GT(fine.face_count(), 500'000);
  const dmat3 R = glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(dvec3(1, 2, -0.5))));
  const std::optional<SensorFrame> guess = guess_frame(turned(fine, R)), coarse = guess_frame(turned(*own_finger(), R));
  ASSERT_TRUE(guess && coarse);
  EXPECT_LT(glm::distance(guess->distal, coarse->distal), 1e-3);
  EXPECT_LT(glm::distance(guess->pad, coarse->pad), 1e-3);
}

TEST(FrameGuess, FollowsAnObliqueFinger) {
  const TriMeshPtr finger = own_finger();
  const dmat3 R = glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(dvec3(1, 2, -0.5))));
  const std::optional<SensorFrame> guess = guess_frame(turned(*finger, R));
  ASSERT_TRUE(guess);
  EXPECT_GT(glm::dot(guess->distal, R * dvec3(0, 0, 1)), 0.97);
  // Pad and back of this finger differ little (skewness 0.025), so either side is accepted for an oblique finger.
  EXPECT_GT(std::abs(glm::dot(guess->pad, R * dvec3(0, -1, 0))), 0.9);
  EXPECT_NEAR(glm::dot(guess->distal, guess->pad), 0, 1e-12);
}

TEST(FrameGuess, ChoosesTheSideOfTheTaxels) {
  const TriMeshPtr finger = own_finger();
  std::vector<Taxel> taxels(3);
  for (Taxel& taxel : taxels) taxel.normal = glm::normalize(dvec3(1, 0.2, 0.3));
  EXPECT_EQ(guess_frame(*finger, taxels)->pad, dvec3(1, 0, 0));
  taxels[1].normal = dvec3(-1, 0, 0), taxels[2].normal = dvec3(0, 1, 0), taxels[0].normal = dvec3(0.9, -0.9, 0);
  EXPECT_EQ(guess_frame(*finger, taxels)->pad, dvec3(0, -1, 0)) << "all around: the shape decides";
}

TEST(FrameGuess, IsEmptyForABodyWithoutATip) {
  EXPECT_FALSE(guess_frame(make_sphere(0.01, 0.002)));
}

TEST(FrameGuess, PointsARodAwayFromTheOriginOfItsFile) {
  const TriMesh rod = make_box(dvec3(0.02, 0.006, 0.007));
  const auto moved = [&](double x) {
    std::vector<dvec3> vertices = rod.vertices();
    for (dvec3& v : vertices) v.x += x;
    return TriMesh(std::move(vertices), rod.faces());
  };
  EXPECT_EQ(guess_frame(moved(0.02))->distal, dvec3(1, 0, 0));
  EXPECT_EQ(guess_frame(moved(-0.03))->distal, dvec3(-1, 0, 0));
  EXPECT_FALSE(guess_frame(moved(0.001))) << "the origin is in the middle";
}

TEST(FrameGuess, IsCorrectOnRealFingers) {
  const std::filesystem::path folder = TAXEL_REAL_DATA;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  struct Finger {
    const char* file;
    dvec3 distal, pad;
  };
  for (const Finger& finger : {Finger{"meshes/shadow_f_distal_pst.stl", {0, 1, 0}, {0, 0, 1}},
                               Finger{"meshes/shadow_f_distal_bt_sp.stl", {0, 1, 0}, {0, 0, 1}},
                               Finger{"paper/ubi_tip_collision.stl", {0, 0, 1}, {0, -1, 0}}}) {
    const std::optional<SensorFrame> guess = guess_frame(*load_mesh(folder / finger.file).mesh);
    ASSERT_TRUE(guess) << finger.file;
    EXPECT_EQ(guess->distal, finger.distal) << finger.file;
    EXPECT_EQ(guess->pad, finger.pad) << finger.file;
  }
  EXPECT_EQ(guess_frame(*load_mesh(folder / "skins/allegro_tip.stl").mesh)->distal, dvec3(0, 0, 1));
  EXPECT_EQ(guess_frame(*load_mesh(folder / "skins/dclaw_tip.obj").mesh)->distal, dvec3(1, 0, 0));
  // Thumbs with oblique axes in the frames of their links. The thumb of the Ability hand tapers at neither end.
  for (const auto& [file, distal] : {std::pair("skins/inspire_thumb.obj", dvec3(0.730, 0.683, -0.001)),
                                     std::pair("skins/ability_thumb.glb", dvec3(-0.867, -0.498, -0.013))})
    EXPECT_GT(glm::dot(guess_frame(*load_mesh(folder / file).mesh)->distal, distal), 0.99) << file;
  EXPECT_FALSE(guess_frame(*load_mesh(folder / "meshes/plate_8in_col.stl").mesh));
}

}  // namespace
}  // namespace taxel
