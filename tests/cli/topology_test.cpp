// `taxel mesh --decimate` and `--subdivide`: numbers of faces, report and errors.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const std::string kFinger = std::string(TAXEL_SOURCE_DIR) + "/assets/meshes/fingertip.obj";

TEST(MeshTopology, DecimatesAndReportsTheDistance) {
  const std::string out = (test_folder() / "few.obj").string();
  const Json found = taxel_json({"mesh", kFinger, "--decimate", "500", "--out", out});
  EXPECT_EQ(found["change"], "decimate");
  EXPECT_LE(found["after"]["triangles"], 500);
  EXPECT_GE(found["after"]["triangles"], 498);
  EXPECT_TRUE(found["after"]["closed"]);
  EXPECT_GT(found["distance_max"], 0.0);
  EXPECT_LT(found["distance_max"], 0.5e-3) << "of a finger of 30 mm";
  EXPECT_LT(found["distance_rms"], found["distance_max"]);
  EXPECT_EQ(taxel_json({"mesh", out})["triangles"], found["after"]["triangles"]);
}

TEST(MeshTopology, SubdividesByMidpointsByDefault) {
  const Json flat = taxel_json({"mesh", kFinger, "--subdivide", "1"});
  EXPECT_EQ(flat["scheme"], "midpoint");
  EXPECT_EQ(flat["after"]["triangles"], 4 * flat["before"]["triangles"].get<int>());
  EXPECT_LT(flat["distance_max"], 1e-12);
  const Json smooth = taxel_json({"mesh", kFinger, "--subdivide", "1", "--scheme", "loop"});
  EXPECT_GT(smooth["distance_max"], 1e-6);
  EXPECT_TRUE(smooth["after"]["closed"]);
  EXPECT_NE(taxel({"mesh", kFinger, "--subdivide", "1"}).out.find("by midpoint"), std::string::npos);
}

TEST(MeshTopology, RefusesBadNumbersAndMeshes) {
  const fs::path folder = test_folder();
  write_text(folder / "fin.obj", box_obj(0.01) + "v 0.1 0.1 0.1\nf 1 2 9\n");
  const std::string box = (folder / "box.obj").string(), fin = (folder / "fin.obj").string();
  write_text(box, box_obj(0.01));
  const auto refused = [&](const std::vector<std::string>& options, const std::string& complaint) {
    std::vector<std::string> arguments{"mesh"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = taxel(arguments);
    EXPECT_EQ(outcome.status, 2) << complaint;
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
  };
  refused({box, "--decimate", "0"}, box + ": must be decimated to 1 face or more, asked for are 0");
  refused({box, "--decimate", "-4"}, box + ": must be decimated to 1 face or more, asked for are -4");
  refused({box, "--decimate", "13"}, box + ": has 12 faces: it cannot be decimated to 13");
  refused({box, "--subdivide", "0"}, box + ": must be subdivided 1 time or more, asked for are 0");
  refused({box, "--subdivide", "40"}, box + ": has 12 faces: subdivided 40 times it has more than 4000000");
  refused({fin, "--decimate", "4"}, fin + ": must be a manifold: 1 edge with more than two faces");
  refused({box, "--decimate", "4", "--subdivide", "1"}, "--decimate excludes --subdivide");
}

}  // namespace
}  // namespace taxel::test
