// A sensor description of the predecessor's code and its mesh, dropped in either order or together.
#include <gtest/gtest.h>

#include <fstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string drop(const std::string& files) {
  return R"({"event": "drop", "files": [)" + files + "]}";
}

/// Two taxels on the tip of our fingertip in millimetres.
class DroppedYaml : public testing::Test {
 protected:
  void SetUp() override {
    write(
        "tip.yaml",
        "MujocoPlugins:\n  - type: s\n    SurfacePlugins:\n    - {type: s/CurvedSensor, sensorName: tip, geomName: g,\n"
        "       include_margin: 0.006, sample_resolution: 1.0e5, updateRate: 40,\n"
        "       taxels: [[0.0041, -0.0061, 0.0146], [-0.0041, -0.0061, 0.0146]],\n"
        "       normals: [[0.37, -0.92, 0.09], [-0.37, -0.92, 0.09]]}\n");
    std::ifstream in(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj");
    std::ofstream out(studio.folder() / "finger.obj");
    for (std::string word; in >> word;) {
      double x = 0, y = 0, z = 0;
      if (word == "v" && in >> x >> y >> z) out << "v " << 1e3 * x << ' ' << 1e3 * y << ' ' << 1e3 * z << '\n';
      std::string rest;
      if (word == "v") continue;
      std::getline(in, rest);
      if (word == "f") out << "f" << rest << '\n';
    }
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(studio.folder() / name) << text; }
  void expect_opened(const Json& state) const {
    ASSERT_FALSE(state["document"].is_null()) << state["messages"].dump();
    EXPECT_NE(state["document"]["file"].get<std::string>().find("tip.yaml"), std::string::npos);
    EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 2U);
    EXPECT_EQ(state["document"]["layout"]["mesh"]["scale"], Json({0.001, 0.001, 0.001}));
    EXPECT_EQ(state["simulation"]["readings"].size(), 2U);
    EXPECT_NE(state["messages"].dump().find("not carried over: updateRate"), std::string::npos);
  }
  StudioProgram studio;
};

TEST_F(DroppedYaml, OpensWithItsMeshInEitherOrderOrTogether) {
  studio.play({drop(R"("tip.yaml", "finger.obj")"), kIdle, dump("together.json")}, {"--empty"});
  expect_opened(studio.state("together.json"));
  studio.play({drop(R"("finger.obj")"), kIdle, drop(R"("tip.yaml")"), kIdle, dump("mesh_first.json")}, {"--empty"});
  expect_opened(studio.state("mesh_first.json"));
  studio.play(
      {drop(R"("tip.yaml")"), kIdle, dump("asked.json"), drop(R"("finger.obj")"), kIdle, dump("yaml_first.json")},
      {"--empty"});
  EXPECT_NE(studio.state("asked.json")["messages"].dump().find("drop or open its mesh file"), std::string::npos);
  expect_opened(studio.state("yaml_first.json"));
}

TEST_F(DroppedYaml, NamesLineAndKeyOfABadFile) {
  write("tip.yaml",
        "MujocoPlugins:\n  - type: s\n    SurfacePlugins:\n    - {type: s/CurvedSensor, include_margin: wide}\n");
  const Outcome outcome = studio.run({drop(R"("tip.yaml", "finger.obj")"), kIdle, dump("bad.json")}, {"--empty"});
  const std::string messages = studio.state("bad.json")["messages"].dump();
  EXPECT_NE(messages.find("line 4, key include_margin: must be a number"), std::string::npos) << messages;
}

}  // namespace
}  // namespace taxel::test
