// Meshes of real robots and scans, if the files are present.
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// Loads a real mesh. Skips the test if the mesh is absent.
class RealMesh : public testing::Test {
 protected:
  LoadedMesh load(const std::string& name, double scale = 1) {
    const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / "meshes" / name;
    return load_mesh(path, dvec3(scale));
  }
  void SetUp() override {
    const std::filesystem::path folder = std::filesystem::path(TAXEL_REAL_DATA) / "meshes";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the real meshes are absent: " << folder;
  }
};

TEST_F(RealMesh, HasASkinAndACavityInTheShadowFingertip) {
  const TriMesh finger = *load("shadow_f_distal_pst.stl", 0.001).mesh;
  EXPECT_EQ(finger.vertex_count(), 2691);
  EXPECT_EQ(finger.face_count(), 5374);
  EXPECT_TRUE(finger.closed());
  ASSERT_EQ(finger.shell_count(), 2);
  const TriMesh skin = extract_shells(finger, outer_shells(finger));
  EXPECT_EQ(skin.face_count(), 5054);
  EXPECT_TRUE(skin.closed());
  EXPECT_GT(skin.volume(), finger.volume());
  const Problems problems = check_mesh(finger, "finger.stl");
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].code, "mesh_cavity");
  EXPECT_NE(problems[0].message.find("320 faces"), std::string::npos) << problems[0].message;
  EXPECT_EQ(problems[1].code, "mesh_self_intersection");  // at the edge of the nail: tiny folds
  EXPECT_EQ(problems[1].severity, Severity::note);
  EXPECT_NE(problems[1].message.find("4 pairs"), std::string::npos) << problems[1].message;
}

TEST_F(RealMesh, IsSuspectedToBeInMillimetresWithoutAScale) {
  const TriMesh finger = *load("shadow_f_distal_bt_sp.stl").mesh;
  EXPECT_EQ(guess_unit(finger).unit, "mm");
  EXPECT_EQ(finger.vertex_count(), 2648);
  EXPECT_EQ(finger.face_count(), 5292);
  EXPECT_TRUE(finger.closed());
}

TEST_F(RealMesh, ClosesTheTextureSeamsOfSpot) {
  const TriMesh spot = *load("spot/spot_triangulated.obj").mesh;
  EXPECT_EQ(spot.face_count(), 5856);
  EXPECT_TRUE(spot.closed());
  EXPECT_EQ(spot.shell_count(), 1);
  EXPECT_TRUE(spot.topology().edges_of(EdgeKind::boundary).empty());
  // Euler: V - E + F = 2 for a body without handles.
  EXPECT_EQ(spot.vertex_count() - spot.topology().edge_count() + spot.face_count(), 2);
}

TEST_F(RealMesh, HasNoProblemsInThePlate) {
  const TriMesh plate = *load("plate_8in_col.stl").mesh;
  EXPECT_EQ(plate.face_count(), 896);
  EXPECT_TRUE(check_mesh(plate, "plate.stl").empty());
}

}  // namespace
}  // namespace taxel
