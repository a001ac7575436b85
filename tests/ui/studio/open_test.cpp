// Opening documents: by argument, by Ctrl+O and by drop; good files and bad ones.
#include <gtest/gtest.h>

#include "studio_program.h"

namespace taxel::test {
namespace {

const std::string kAssets = TAXEL_SOURCE_DIR "/assets";

/// Types a path into the file dialog and presses Enter.
std::vector<std::string> open_by_dialog(const std::string& path) {
  return {R"({"event": "key", "key": "o", "mods": ["ctrl"]})",
          R"({"do": "wait_idle"})",
          R"({"event": "text", "text": ")" + path + R"("})",
          R"({"do": "wait_idle"})",
          R"({"event": "key", "key": "Enter"})",
          R"({"do": "wait_idle"})"};
}

std::vector<std::string> drop(const std::string& path) {
  return {R"({"event": "drop", "files": [")" + path + R"("]})", R"({"do": "wait_idle"})"};
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::string kDump = R"({"do": "dump_state", "file": "state.json"})";

void expect_bare_mesh(const Json& state, const std::string& file) {
  EXPECT_EQ(state["mode"], "layout");
  EXPECT_EQ(state["document"]["file"], file);
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 0U);
  EXPECT_GT(state["document"]["mesh"]["triangles"], 1000);
  EXPECT_TRUE(state["simulation"].is_null());
  ASSERT_FALSE(state["messages"].empty());
  EXPECT_NE(state["messages"][0]["text"].get<std::string>().find("metres"), std::string::npos) << "the unit is said";
}

void expect_layout(const Json& state, const std::string& file) {
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_EQ(state["document"]["file"], file);
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(state["simulation"]["readings"].size(), 12U);
  EXPECT_EQ(state["messages"].dump().find("error"), std::string::npos) << state["messages"].dump();
}

TEST(Open, WithoutAnArgumentTheFingertipSweepPlays) {
  const StudioProgram studio;
  studio.play({R"({"frame": 3, "do": "dump_state", "file": "state.json"})"});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_TRUE(state["simulation"]["playing"]);
  EXPECT_GT(state["simulation"]["step"], 0);
}

TEST(Open, CtrlOOpensAMeshAndALayout) {
  const StudioProgram studio;
  const std::string glb = kAssets + "/meshes/fingertip.glb", layout = kAssets + "/layouts/fingertip.taxels.json";
  auto script = joined(open_by_dialog(glb), {R"({"do": "dump_state", "file": "mesh.json"})"});
  script = joined(script, joined(open_by_dialog(layout), {kDump}));
  studio.play(script);
  expect_bare_mesh(studio.state("mesh.json"), glb);
  expect_layout(studio.state("state.json"), layout);
}

TEST(Open, DropOpensAMeshAndALayout) {
  const StudioProgram studio;
  const std::string glb = kAssets + "/meshes/fingertip.glb", layout = kAssets + "/layouts/fingertip.taxels.json";
  auto script = joined(drop(glb), {R"({"do": "dump_state", "file": "mesh.json"})"});
  script = joined(script, joined(drop(layout), {kDump}));
  studio.play(script);
  expect_bare_mesh(studio.state("mesh.json"), glb);
  expect_layout(studio.state("state.json"), layout);
}

TEST(Open, TheListOfTheDialogOpensWithADoubleClick) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "meshes");
  std::filesystem::copy_file(kAssets + "/meshes/fingertip.obj", studio.folder() / "meshes" / "one.obj");
  write_text(studio.folder() / "notes.txt", "not to be listed");
  studio.play({R"({"event": "key", "key": "o", "mods": ["ctrl"]})", R"({"do": "wait_idle"})", kDump,
               R"({"event": "click", "at": {"widget": "meshes/"}})", R"({"do": "wait_idle"})",
               R"({"event": "double_click", "at": {"widget": "one.obj"}})", R"({"do": "wait_idle"})",
               R"({"do": "dump_state", "file": "opened.json"})"});
  const std::string widgets = studio.state("state.json")["widgets"].dump();
  EXPECT_EQ(widgets.find("notes.txt"), std::string::npos);
  expect_bare_mesh(studio.state("opened.json"), (studio.folder() / "meshes" / "one.obj").string());
}

TEST(Open, AMeshInMillimetresIsScaled) {
  const StudioProgram studio;
  const std::string mesh = file_text(kAssets + "/meshes/fingertip.obj");
  std::string scaled;
  std::istringstream lines(mesh);
  for (std::string line; std::getline(lines, line);) {
    double x = 0, y = 0, z = 0;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) {
      line = "v " + std::to_string(1e3 * x) + " " + std::to_string(1e3 * y) + " " + std::to_string(1e3 * z);
    }
    scaled += line + "\n";
  }
  write_text(studio.folder() / "mm.obj", scaled);
  studio.play({R"({"do": "wait_idle"})", kDump}, {"mm.obj"});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["document"]["layout"]["mesh"]["scale"], (std::vector<double>{0.001, 0.001, 0.001}));
  EXPECT_NE(state["messages"].dump().find("millimetres"), std::string::npos);
}

/// A bad file says what is wrong, and the sweep goes on as if nothing had been asked.
void expect_refused(const std::string& name, const std::string& text, const std::vector<std::string>& said) {
  const StudioProgram studio;
  write_text(studio.folder() / name, text);
  studio.play({R"({"frame": 5, "do": "dump_state", "file": "before.json"})",
               R"({"frame": 6, "event": "drop", "files": [")" + name + R"("]})",
               R"({"frame": 8, "do": "dump_state", "file": "state.json"})"});
  const Json before = studio.state("before.json"), state = studio.state("state.json");
  EXPECT_EQ(state["document"], before["document"]);
  EXPECT_EQ(state["simulation"]["step"], before["simulation"]["step"].get<int>() + 60)
      << "three pictures of twenty steps";
  EXPECT_TRUE(state["simulation"]["playing"]);
  ASSERT_EQ(state["messages"].size(), 1U) << state["messages"].dump();
  EXPECT_EQ(state["messages"][0]["severity"], "error");
  EXPECT_TRUE(state["messages"][0]["shown"]);
  const auto message = state["messages"][0]["text"].get<std::string>();
  for (const std::string& part : said) EXPECT_NE(message.find(part), std::string::npos) << message;
}

std::string broken_layout(const std::string& pointer, const Json& value) {
  Json layout = Json::parse(file_text(kAssets + "/layouts/fingertip.taxels.json"));
  layout["mesh"]["file"] = kAssets + "/meshes/fingertip.obj";
  layout[Json::json_pointer(pointer)] = value;
  return layout.dump();
}

TEST(BadFile, NegativeRadius) {
  expect_refused("bad.taxels.json", broken_layout("/taxels/3/radius", -0.006), {"bad.taxels.json", "/taxels/3/radius"});
}
TEST(BadFile, UnknownVersion) {
  expect_refused("bad.taxels.json", broken_layout("/version", 99), {"bad.taxels.json", "/version"});
}
TEST(BadFile, MissingMesh) {
  expect_refused("bad.taxels.json", broken_layout("/mesh/file", "nowhere.obj"), {"nowhere.obj"});
}
TEST(BadFile, MeshWithoutTriangles) {
  expect_refused("empty.obj", "v 0 0 0\n", {"empty.obj"});
}
TEST(BadFile, SceneThatDoesNotCompile) {
  expect_refused("bad.xml", "<mujoco><worldbody><geom type='sphere'/></worldbody></mujoco>", {"bad.xml"});
}
TEST(BadFile, UnknownKind) {
  expect_refused("photo.bmp", "BM", {"photo.bmp"});
}

TEST(BadFile, TheMessageIsCopiedAndClosed) {
  const StudioProgram studio;
  studio.play({R"({"event": "drop", "files": ["nothing.obj"]})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Copy"}})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Close"}})", R"({"do": "wait_idle"})",
               R"({"event": "key", "key": "o", "mods": ["ctrl"]})", R"({"do": "wait_idle"})",
               R"({"event": "key", "key": "v", "mods": ["ctrl"]})",  // the dialog shows what was copied
               R"({"do": "wait_idle"})", R"({"event": "key", "key": "Enter"})", R"({"do": "wait_idle"})", kDump});
  const Json messages = studio.state("state.json")["messages"];
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_FALSE(messages[0]["shown"]);
  const auto copied = messages[0]["text"].get<std::string>();
  EXPECT_NE(messages[1]["text"].get<std::string>().find(copied), std::string::npos)
      << "the copied text was opened as a path: " << messages[1]["text"];
}

TEST(Open, AfterCloseTheCardOffersTheSweep) {
  const StudioProgram studio;
  studio.play({R"({"event": "click", "at": {"widget": "File"}})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Close"}})", R"({"do": "wait_idle"})",
               R"({"do": "dump_state", "file": "closed.json"})",
               R"({"event": "click", "at": {"widget": "Fingertip sweep"}})", R"({"do": "wait_idle"})", kDump});
  EXPECT_TRUE(studio.state("closed.json")["document"].is_null());
  EXPECT_TRUE(studio.state("closed.json")["simulation"].is_null());
  EXPECT_EQ(studio.state("state.json")["document"]["layout"]["taxels"].size(), 12U);
}

TEST(Open, TheRealFingertip) {
  const std::string layout = TAXEL_REAL_DATA "/shadow_fingertip.taxels.json";
  if (!std::filesystem::exists(layout)) GTEST_SKIP() << layout << " is absent";
  const StudioProgram studio;
  studio.play({R"({"do": "wait_time", "time": 1.2})", kDump, R"({"do": "screenshot", "file": "real.png"})"}, {layout});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["document"]["mesh"]["shells"], 2);
  double largest = 0;
  for (const double reading : state["simulation"]["readings"]) largest = std::max(largest, reading);
  EXPECT_GT(largest, 1000) << "Pa at mid-sweep";
}

}  // namespace
}  // namespace taxel::test
