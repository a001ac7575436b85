// Layouts with errors and layouts whose mesh is missing: the window opens them to be mended, or asks for the mesh.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns our fingertip's layout, on its mesh.
Json fingertip() {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 1e5;
  return layout;
}

/// Returns the arguments that open a layout in a window where all fields of the inspector are visible.
std::vector<std::string> opened(const StudioProgram& studio, const Json& layout) {
  write_text(studio.folder() / "bad.taxels.json", layout.dump());
  return tall_window(studio, "bad.taxels.json");
}

std::string line_of(const Json& state) {
  std::string text;
  for (const Json& message : state["messages"])
    if (message["shown"]) text += message["text"].get<std::string>() + "\n";
  return text;
}

TEST(InvalidLayout, OpensWithItsProblemAndIsMended) {
  const StudioProgram studio;
  Json layout = fingertip();
  layout["taxels"][2]["radius"] = -0.006;
  layout["taxels"][5]["normal"] = {0, 0, 0};
  studio.play({kIdle, dump("bad.json"), press("Fix all"), kIdle, dump("good.json")}, opened(studio, layout));
  const Json bad = studio.state("bad.json"), good = studio.state("good.json");
  EXPECT_EQ(bad["mode"], "layout");
  EXPECT_EQ(bad["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(bad["document"]["layout"]["taxels"][2]["radius"], -0.006) << "as it is in the file";
  EXPECT_NE(line_of(bad).find("/taxels/2/radius: must be greater than 0, is -0.006"), std::string::npos)
      << line_of(bad);
  EXPECT_EQ(good["document"]["layout"]["taxels"][2]["radius"], 0.006);
  EXPECT_EQ(line_of(good).find("/taxels/2/radius"), std::string::npos) << "it is not true any more: " << line_of(good);
}

TEST(InvalidLayout, IsDisplayedWithoutItsWrongTaxels) {
  const StudioProgram studio;
  Json few = fingertip(), wrong = fingertip();
  for (const int index : {9, 4}) few["taxels"].erase(static_cast<std::size_t>(index));
  wrong["taxels"][4]["radius"] = -0.006;
  for (Json& x : wrong["taxels"][9]["center"]) x = 3 * x.get<double>();  // far from the surface
  studio.play({kIdle, dump("few.json")}, opened(studio, few));
  studio.play({kIdle, dump("wrong.json")}, opened(studio, wrong));
  EXPECT_GT(studio.state("few.json")["document"]["samples"], 0);
  EXPECT_EQ(studio.state("wrong.json")["document"]["samples"], studio.state("few.json")["document"]["samples"]);
}

TEST(InvalidLayout, IsAskedWhetherItsCentresAreInMillimetres) {
  const StudioProgram studio;
  Json layout = fingertip();
  for (Json& taxel : layout["taxels"])
    for (Json& x : taxel["center"]) x = 1e3 * x.get<double>();
  studio.play({kIdle, dump("mm.json"), press("Read the centres in mm"), kIdle, dump("m.json")}, opened(studio, layout));
  const Json in_m = studio.state("m.json");
  EXPECT_NE(line_of(studio.state("mm.json")).find("are they in mm?"), std::string::npos);
  const Json right = fingertip();
  for (std::size_t k = 0; k < 12; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(in_m["document"]["layout"]["taxels"][k]["center"][i].get<double>(),
                  right["taxels"][k]["center"][i].get<double>(), 1e-12);
  EXPECT_EQ(line_of(in_m).find("are they in mm?"), std::string::npos) << line_of(in_m);
}

TEST(MissingMesh, IsNamedWithItsLayoutAndLocated) {
  const StudioProgram studio;
  Json layout = fingertip();
  layout["mesh"]["file"] = "lost.obj";
  write_text(studio.folder() / "finger.taxels.json", layout.dump());
  studio.play({R"({"event": "drop", "files": ["finger.taxels.json"]})", kIdle, dump("lost.json"),
               R"({"do": "screenshot", "file": "lost.png"})", press("Locate..."), kIdle, key("a", kCtrl),
               type(kMeshFile), kIdle, key("Enter"), kIdle, dump("found.json")},
              {"--empty"});
  const Json lost = studio.state("lost.json"), found = studio.state("found.json");
  EXPECT_TRUE(lost["document"].is_null());
  ASSERT_EQ(lost["notices"].size(), 1U) << lost["notices"];
  EXPECT_NE(lost["notices"].dump().find("finger.taxels.json asks for the mesh lost.obj"), std::string::npos)
      << lost["notices"];
  EXPECT_NE(line_of(lost).find("finger.taxels.json: /mesh/file: "), std::string::npos) << line_of(lost);
  EXPECT_EQ(found["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(found["document"]["layout"]["mesh"]["file"], kMeshFile);
  EXPECT_TRUE(found["notices"].empty());
  EXPECT_EQ(line_of(found).find("no such file"), std::string::npos) << line_of(found);
}

TEST(MissingMesh, IsForgottenIfAllIsLeftAsItIs) {
  const StudioProgram studio;
  Json layout = fingertip();
  layout["mesh"]["file"] = "lost.obj";
  write_text(studio.folder() / "finger.taxels.json", layout.dump());
  studio.play({R"({"event": "drop", "files": ["finger.taxels.json"]})", kIdle, press("Leave as it is"), kIdle,
               R"({"event": "drop", "files": [")" + kMeshFile + R"("]})", kIdle, dump("mesh.json")},
              {"--empty"});
  EXPECT_TRUE(studio.state("mesh.json")["document"]["layout"]["taxels"].empty()) << "a bare mesh";
}

TEST(ProbeKey, SaysWhyThereIsNothingToProbe) {
  const StudioProgram studio;
  studio.play({kIdle, key("x"), kIdle, dump("state.json")}, {"--empty"});
  EXPECT_NE(line_of(studio.state("state.json")).find("No probe: there is no sensor"), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
