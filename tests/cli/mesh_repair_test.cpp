// `taxel mesh --repair` through the real executable.
#include "cli/taxel_program.h"
#include "core/base/files.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Makes a folder with ball.obj, a sphere of 10 mm with a missing face and a fin.
fs::path folder_with_broken_ball() {
  const fs::path folder = test_folder();
  save_mesh(folder / "ball.obj", with_fin(without_faces(make_icosphere(0.01, 3), {7}), 500, 0.002));
  return folder;
}

TEST(MeshRepair, WritesTheRepairedMeshAndReportsEachStep) {
  const fs::path folder = folder_with_broken_ball();
  const std::string before = read_file(folder / "ball.obj");
  const Json mesh = taxel_json({"mesh", "ball.obj", "--repair", "auto", "--out", "fixed.stl"}, folder);
  EXPECT_EQ(mesh["closed"], false);  // the file itself is open
  const Json repair = mesh["repair"];
  EXPECT_EQ(repair["level"], "exact");
  EXPECT_EQ(repair["closed"], true);
  EXPECT_EQ(repair["faces_before"], 1280);
  EXPECT_EQ(repair["faces_after"], 1280);
  EXPECT_EQ(repair["shells_after"], 1);
  EXPECT_EQ(repair["vertices_moved"], 0);
  EXPECT_EQ(repair["distance_max"], 0.0);
  EXPECT_GT(repair["area_added"].get<double>(), 0);
  EXPECT_GT(repair["area_removed"].get<double>(), 0);
  ASSERT_EQ(repair["steps"].size(), 2U);
  EXPECT_EQ(repair["steps"][0]["code"], "repair_fin");
  EXPECT_EQ(repair["steps"][1]["code"], "repair_filled");
  for (const char* key : {"count", "faces", "area", "length", "place"}) EXPECT_TRUE(repair["steps"][0].contains(key));
  EXPECT_EQ(read_file(folder / "ball.obj"), before);
  const Json again = taxel_json({"mesh", "fixed.stl", "--repair", "auto"}, folder);
  EXPECT_EQ(again["closed"], true);
  EXPECT_EQ(again["repair"]["level"], "keep");
  EXPECT_TRUE(again["repair"]["steps"].empty());
}

TEST(MeshRepair, DescribesEachStepInWords) {
  const fs::path folder = folder_with_broken_ball();
  const Outcome outcome = taxel({"mesh", "ball.obj", "--repair", "exact"}, folder);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("repaired: 1 fin removed ("), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("% of the area), 1 hole filled ("), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("no vertex moved"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1280 triangles, closed, 1 shell"), std::string::npos) << outcome.out;
}

TEST(MeshRepair, WrapsOnRequest) {
  const fs::path folder = folder_with_broken_ball();
  const Json mesh = taxel_json({"mesh", "ball.obj", "--repair", "wrap", "--edge", "0.001"}, folder);
  EXPECT_EQ(mesh["repair"]["level"], "wrap");
  EXPECT_EQ(mesh["repair"]["closed"], true);
  EXPECT_GT(mesh["repair"]["distance_rms"].get<double>(), 0);
  EXPECT_LT(mesh["repair"]["distance_rms"].get<double>(), 2e-4);
}

TEST(MeshRepair, NamesFileAndKeyOfBadInput) {
  const fs::path folder = folder_with_broken_ball();
  expect_refusal(taxel({"mesh", "ball.obj", "--repair", "auto", "--edge", "-0.001"}, folder),
                 "taxel: ball.obj: /mesh/repair/edge: must be greater than 0, is -0.001");
  write_text(folder / "fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
  expect_refusal(taxel({"mesh", "fold.obj", "--repair", "auto"}, folder),
                 "taxel: fold.obj: /mesh/file: encloses nothing: its faces have no inside");
  const Outcome kept = taxel({"mesh", "ball.obj", "--repair", "keep"}, folder);
  EXPECT_EQ(kept.status, 2);
  EXPECT_NE(kept.err.find("must be a closed mesh to be soft"), std::string::npos) << kept.err;
  EXPECT_EQ(taxel({"mesh", "ball.obj", "--edge", "0.001"}, folder).status, 2);
}

}  // namespace
}  // namespace taxel::test
