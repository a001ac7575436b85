// `taxel generate`: layouts by patterns on a mesh and on the bodies of a scene, which run, and refusals.
#include <set>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const fs::path kAssets = fs::path(TAXEL_SOURCE_DIR) / "assets";
const std::string kMesh = (kAssets / "meshes/fingertip.obj").string();
const std::string kHand = (kAssets / "scenes/hand_grasps_ball.xml").string();

TEST(GenerateCommand, WritesALayoutThatChecksAndSweeps) {
  const fs::path folder = test_folder();
  const Json made = taxel_json({"generate", kMesh, "--pattern", "hexagonal", "--pitch", "4mm", "--region", "z > 8 mm",
                                "--out", "finger.taxels.json"},
                               folder)["layouts"];
  ASSERT_EQ(made.size(), 1U);
  const Json layout = Json::parse(file_text(folder / "finger.taxels.json"));
  EXPECT_EQ(layout["taxels"].size(), made[0]["taxels"].get<std::size_t>());
  EXPECT_GT(layout["taxels"].size(), 10U);
  EXPECT_EQ(taxel({"check", "finger.taxels.json"}, folder).status, 0);
  (void)taxel_json({"sweep", "--layout", "finger.taxels.json", "--out", "swept"}, folder);
  const Table table = read_csv(folder / "swept/readings.csv");
  double peak = 0;
  for (const auto& [name, column] : table)
    if (name.starts_with("taxel_"))
      for (const double value : column) peak = std::max(peak, value);
  EXPECT_GT(peak, 1000) << "the finger slides over an edge";
}

TEST(GenerateCommand, HasTheFieldsOfEveryPatternAsOptions) {
  const fs::path folder = test_folder();
  const auto taxels = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"generate", kMesh, "--out", "one.taxels.json", "--pattern"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taxel_json(arguments, folder)["layouts"][0]["taxels"].get<int>();
  };
  EXPECT_EQ(taxels({"grid", "--rows", "3", "--columns", "2", "--row-pitch", "3 mm", "--column-pitch", "0.003"}), 6);
  EXPECT_EQ(taxels({"ring", "--count", "8", "--axis", "Z"}), 8);
  EXPECT_EQ(taxels({"spread", "--count", "9", "--seed", "3", "--region", "ny < -0.5"}), 9);
  EXPECT_EQ(taxels({"preset", "--preset", "icub"}), 12);
  write_text(folder / "points.csv", "x,y,z\n0,-8,12\n0,-8,16\n");
  EXPECT_EQ(taxels({"table", "--table", "points.csv", "--unit", "mm"}), 2);
}

TEST(GenerateCommand, WritesALayoutForEachMeshOfASceneThatRuns) {
  const fs::path folder = test_folder();
  const Json made = taxel_json({"generate", kHand, "--pitch", "4mm", "--pad", "0,-1,0", "--distal", "0,0,1", "--out",
                                "layouts", "--body", "index tip", "--body", "thumb tip", "--body", "thumb middle"},
                               folder)["layouts"];
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0]["bodies"], Json::parse(R"(["index tip", "thumb tip"])")) << "they share a mesh";
  EXPECT_EQ(made[1]["bodies"], Json::parse(R"(["thumb middle"])"));
  const Json middle = Json::parse(file_text(folder / made[1]["file"].get<std::string>()));
  EXPECT_NEAR(middle["mesh"]["scale"][0].get<double>(), 1.18, 1e-9) << "as in the scene";
  for (const Json& layout : made)
    EXPECT_EQ(taxel({"check", layout["file"].get<std::string>()}, folder).status, 0) << layout;
  const Json all = taxel_json({"generate", kHand, "--pad", "0,-1,0", "--distal", "0,0,1", "--out", "all"}, folder);
  std::set<std::string> bodies;
  for (const Json& layout : all["layouts"])
    for (const Json& body : layout["bodies"]) bodies.insert(body.get<std::string>());
  EXPECT_EQ(bodies.size(), 17U) << "forearm, palm, and three links of each finger";
}

TEST(GenerateCommand, RefusesBadInput) {
  const fs::path folder = test_folder();
  const auto expect = [&](std::vector<std::string> arguments, const std::string& line) {
    arguments.insert(arguments.begin(), "generate");
    expect_refusal(taxel(arguments, folder), "taxel: " + line);
  };
  const std::vector<std::string> out{"--out", "f.taxels.json"};
  expect({kMesh, "--pattern", "ring", "--pitch", "4mm", out[0], out[1]},
         "generate: --pitch: is no value of the pattern ring, which has count, axis, turn_deg, radius");
  EXPECT_NE(
      taxel({"generate", kMesh, "--pitch", "4 N", out[0], out[1]}, folder).err.find("generate: --pitch: \"4 N\": "),
      std::string::npos);
  expect({kMesh, "--pad", "1,2", out[0], out[1]}, "generate: --pad: must be three numbers X,Y,Z, is \"1,2\"");
  expect({kMesh, "--out", "f.json"}, "generate: --out: must end with .taxels.json, is f.json");
  expect({kMesh, "--body", "a", out[0], out[1]},
         "generate: --body: needs a scene (.xml, .mjcf, .urdf), " + kMesh + " is a mesh");
  expect({kHand, "--scale", "2", "--out", "x"},
         "generate: --scale: is for a mesh: a scene gives the scale of its meshes");
  expect({kHand, "--body", "tail", "--out", "x"}, kHand + ": has no body \"tail\"");
  expect({kHand, "--body", "ball", "--out", "x"},
         kHand + ": body \"ball\" has no geom with a mesh: its shapes are MuJoCo's own, which have no file");
  EXPECT_FALSE(fs::exists(folder / "f.taxels.json"));
  EXPECT_FALSE(fs::exists(folder / "x"));
}

}  // namespace
}  // namespace taxel::test
