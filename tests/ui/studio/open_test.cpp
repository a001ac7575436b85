// Opening documents: by argument, by Ctrl+O and by drop; good files and bad ones.
#include <gtest/gtest.h>

#include "fixtures/finger_scene_xml.h"
#include "script_lines.h"

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
  EXPECT_NE(state["messages"][0]["text"].get<std::string>().find("assumed unit: m;"), std::string::npos)
      << "the unit is said";
}

void expect_layout(const Json& state, const std::string& file) {
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_EQ(state["document"]["file"], file);
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(state["simulation"]["readings"].size(), 12U);
  EXPECT_EQ(state["messages"].dump().find("error"), std::string::npos) << state["messages"].dump();
}

TEST(Open, PlaysTheFingertipSweepWithoutAnArgument) {
  const StudioProgram studio;
  studio.play({R"({"frame": 3, "do": "dump_state", "file": "state.json"})"});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_TRUE(state["simulation"]["playing"]);
  EXPECT_GT(state["simulation"]["step"], 0);
}

TEST(Open, ReadsAMeshAndALayoutByCtrlO) {
  const StudioProgram studio;
  const std::string glb = kAssets + "/meshes/fingertip.glb", layout = kAssets + "/layouts/fingertip.taxels.json";
  auto script = joined(open_by_dialog(glb), {R"({"do": "dump_state", "file": "mesh.json"})"});
  script = joined(script, joined(open_by_dialog(layout), {kDump}));
  studio.play(script);
  expect_bare_mesh(studio.state("mesh.json"), glb);
  expect_layout(studio.state("state.json"), layout);
}

TEST(Open, ReadsADroppedMeshAndLayout) {
  const StudioProgram studio;
  const std::string glb = kAssets + "/meshes/fingertip.glb", layout = kAssets + "/layouts/fingertip.taxels.json";
  auto script = joined(drop(glb), {R"({"do": "dump_state", "file": "mesh.json"})"});
  script = joined(script, joined(drop(layout), {kDump}));
  studio.play(script);
  expect_bare_mesh(studio.state("mesh.json"), glb);
  expect_layout(studio.state("state.json"), layout);
}

TEST(Open, ReadsAFileOfTheDialogByDoubleClick) {
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

TEST(Open, ScalesAMeshInMillimetres) {
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
  EXPECT_NE(state["messages"].dump().find("assumed unit: mm"), std::string::npos);
}

/// A bad file and the words that its message must contain.
struct BadFile {
  std::string name, text;
  std::vector<std::string> said;
};

BadFile broken_layout(const std::string& pointer, const Json& value, const std::vector<std::string>& said = {}) {
  Json layout = Json::parse(file_text(kAssets + "/layouts/fingertip.taxels.json"));
  layout["mesh"]["file"] = kAssets + "/meshes/fingertip.obj";
  layout[Json::json_pointer(pointer)] = value;
  return {"bad.taxels.json", layout.dump(), said.empty() ? std::vector<std::string>{"bad.taxels.json", pointer} : said};
}

std::string broken_scene(const std::string& world, const std::string& geom) {
  return "<mujoco><extension><plugin plugin='taxel.sensor'><instance name='s'><config key='layout' value='" + kAssets +
         "/layouts/fingertip.taxels.json'/><config key='geom' value='" + geom +
         "'/></instance></plugin></extension><worldbody>" + world +
         "</worldbody><sensor><plugin plugin='taxel.sensor' instance='s'/></sensor></mujoco>";
}

/// Each message names the error, and the sweep continues undisturbed.
TEST(BadFile, IsNamedAndTheSweepContinues) {
  const std::string ball = "<geom name='ball' size='1'/>";
  std::vector<BadFile> bad{broken_layout("/taxels/5/center", "here"),
                           broken_layout("/version", 99),
                           {"empty.obj", "v 0 0 0\n", {"empty.obj", "no triangles"}},
                           {"nan.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", {"nan.obj", "line 3", "not finite"}},
                           {"bad.xml", "<mujoco><worldbody><geom type='sphere'/></worldbody></mujoco>", {"bad.xml"}},
                           {"geom.xml", broken_scene(ball, "hand"), {"geom.xml", "\"hand\""}},
                           {"photo.bmp", "BM", {"photo.bmp"}},
                           // Its message ends when another file is opened, so it comes last.
                           broken_layout("/mesh/file", "nowhere.obj", {"nowhere.obj", "no such file"})};
  const StudioProgram studio;
  std::vector<std::string> script{R"({"frame": 5, "do": "dump_state", "file": "before.json"})"};
  int frame = 6;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const std::string folder = std::to_string(i);
    std::filesystem::create_directories(studio.folder() / folder);
    write_text(studio.folder() / folder / bad[i].name, bad[i].text);
    script.push_back(R"({"frame": )" + std::to_string(frame++) + R"(, "event": "drop", "files": [")" + folder + "/" +
                     bad[i].name + R"("]})");
  }
  script.push_back(R"({"frame": )" + std::to_string(frame + 1) + R"(, "do": "dump_state", "file": "state.json"})");
  studio.play(script);
  const Json before = studio.state("before.json"), state = studio.state("state.json");
  EXPECT_EQ(state["document"], before["document"]);
  const int pictures = frame + 1 - 5;
  EXPECT_EQ(state["simulation"]["step"], before["simulation"]["step"].get<int>() + 20 * pictures);
  EXPECT_TRUE(state["simulation"]["playing"]);
  ASSERT_EQ(state["messages"].size(), bad.size()) << state["messages"].dump();
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const Json& message = state["messages"][i];
    EXPECT_EQ(message["severity"], "error");
    EXPECT_TRUE(message["shown"]);
    const auto text = message["text"].get<std::string>();
    for (const std::string& part : bad[i].said) EXPECT_NE(text.find(part), std::string::npos) << part << ": " << text;
  }
}

TEST(BadFile, IsReportedForAFolderThatCannotBeWritten) {
  const StudioProgram studio;  // the screenshot's key writes to the working folder; nobody can write to /proc
  write_text(studio.folder() / "script.jsonl", R"({"event": "key", "key": "p", "mods": ["ctrl"]})"
                                               "\n"
                                               R"({"do": "wait_idle"})"
                                               "\n");
  const std::string state = (studio.folder() / "state.json").string();
  const Outcome outcome = run_program(
      STUDIO_PROGRAM, {"--headless", "--script", (studio.folder() / "script.jsonl").string(), "--dump-state", state},
      "/proc");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json messages = studio.state("state.json")["messages"];
  ASSERT_EQ(messages.size(), 1U) << messages.dump();
  EXPECT_EQ(messages[0]["severity"], "error");
  EXPECT_NE(messages[0]["text"].get<std::string>().find("screenshot-1.png: cannot be written"), std::string::npos)
      << messages[0]["text"];
}

TEST(BadFile, HasAMessageThatCanBeCopiedAndClosed) {
  const StudioProgram studio;
  studio.play({R"({"event": "drop", "files": ["nothing.obj"]})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Copy"}})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Close"}})", R"({"do": "wait_idle"})",
               R"({"event": "key", "key": "o", "mods": ["ctrl"]})", R"({"do": "wait_idle"})",
               R"({"event": "key", "key": "v", "mods": ["ctrl"]})",  // the dialog shows the copied text
               R"({"do": "wait_idle"})", R"({"event": "key", "key": "Enter"})", R"({"do": "wait_idle"})", kDump});
  const Json state = studio.state("state.json"), messages = state["messages"];
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_FALSE(messages[0]["shown"]);
  EXPECT_EQ(state["file_dialog"]["path"], messages[0]["text"]) << "the copied text is in the field of the path";
  EXPECT_NE(state["file_dialog"]["error"], "") << "it is no file";
}

TEST(Open, RunsASceneAndShowsItsWarningsOnce) {
  const StudioProgram studio;
  std::filesystem::copy_file(kAssets + "/meshes/fingertip.obj", studio.folder() / "fingertip.obj");
  Json layout = Json::parse(file_text(kAssets + "/layouts/fingertip.taxels.json"));
  layout["mesh"]["file"] = "fingertip.obj";
  layout["sampling"]["density"] = 1e6;
  write_text(studio.folder() / "finger.taxels.json", layout.dump());
  write_text(studio.folder() / "scene.xml",
             finger_scene(finger_body("thumb", 0, true, "<freejoint/>") + finger_body("index", 0.1), {"thumb", "index"},
                          "finger.taxels.json"));
  studio.play({R"({"event": "drop", "files": ["scene.xml"]})", R"({"do": "wait_idle"})",
               R"({"do": "wait_time", "time": 0.1})", kDump, R"({"event": "key", "key": "Backspace"})",
               R"({"do": "wait_idle"})", R"({"event": "key", "key": "Space"})", R"({"do": "wait_time", "time": 0.1})",
               R"({"do": "dump_state", "file": "again.json"})"});
  const Json state = studio.state("state.json");
  EXPECT_EQ(state["mode"], "simulate");
  EXPECT_EQ(state["document"]["file"], (studio.folder() / "scene.xml").string());
  EXPECT_GT(state["simulation"]["sensors"][1]["polygons"], 0);
  ASSERT_EQ(state["messages"].size(), 1U) << state["messages"].dump();
  EXPECT_EQ(state["messages"][0]["severity"], "warning");
  EXPECT_NE(state["messages"][0]["text"].get<std::string>().find("sensor \"thumb\": MuJoCo's own contact"),
            std::string::npos);
  EXPECT_EQ(studio.state("again.json")["messages"], state["messages"]) << "said once";
}

TEST(Open, OffersTheSweepAfterClose) {
  const StudioProgram studio;
  studio.play({R"({"event": "click", "at": {"widget": "File"}})", R"({"do": "wait_idle"})",
               R"({"event": "click", "at": {"widget": "Close"}})", R"({"do": "wait_idle"})",
               R"({"do": "dump_state", "file": "closed.json"})",
               R"({"event": "click", "at": {"widget": "Fingertip sweep"}})", R"({"do": "wait_idle"})", kDump});
  EXPECT_TRUE(studio.state("closed.json")["document"].is_null());
  EXPECT_TRUE(studio.state("closed.json")["simulation"].is_null());
  EXPECT_EQ(studio.state("state.json")["document"]["layout"]["taxels"].size(), 12U);
}

TEST(Open, ReadsTheRealFingertip) {
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

TEST(MessageLine, IsBelowTheViewAndClosesAllMessages) {
  const StudioProgram studio;
  studio.play({kIdle, dump("before.json"), R"({"event": "drop", "files": ["a.obj"]})", kIdle, dump("one.json"),
               R"({"event": "drop", "files": ["b.obj"]})", kIdle, R"({"event": "drop", "files": ["c.obj"]})", kIdle,
               dump("three.json"), R"({"do": "screenshot", "file": "three.png"})", press("Message/Close all"), kIdle,
               dump("closed.json")},
              {kLayoutFile});
  const Json before = studio.state("before.json"), one = studio.state("one.json"), three = studio.state("three.json");
  const auto place = [](const Json& state, const std::string& label) -> Json {
    for (const Json& widget : state["widgets"])
      if (widget["panel"] == "Message" && widget["label"] == label) return widget["rect"];
    return nullptr;
  };
  EXPECT_TRUE(place(before, "Close").is_null());
  EXPECT_FALSE(place(one, "Close").is_null());
  EXPECT_TRUE(place(one, "Close all").is_null()) << "there is only one";
  const std::string newest = three["messages"][2]["text"];
  EXPECT_NE(newest.find("c.obj"), std::string::npos);
  const Json text = place(three, newest);
  ASSERT_FALSE(text.is_null());
  EXPECT_FALSE(place(three, "2 more").is_null());
  EXPECT_GE(text[1], three["view"]["rect"][3]) << "the view is not covered";
  EXPECT_LT(text[3].get<double>() - text[1].get<double>(), 24) << "one line";
  const Json closed = studio.state("closed.json");
  ASSERT_EQ(closed["messages"].size(), 3U) << "they stay in the list";
  for (const Json& message : closed["messages"]) EXPECT_FALSE(message["shown"]);
  EXPECT_EQ(closed["view"]["rect"], before["view"]["rect"]);
}

TEST(MessageLine, DoesNotDisplayThatVerticesWereWelded) {
  const StudioProgram studio;
  // A tetrahedron whose faces have corners of their own.
  write_text(studio.folder() / "loose.obj",
             "v 0 0 0\nv 0 9 0\nv 9 0 0\nv 0 0 0\nv 9 0 0\nv 0 0 9\nv 0 0 0\nv 0 0 9\nv 0 9 0\n"
             "v 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n");
  studio.play({kIdle, dump("state.json")}, {"loose.obj"});
  int welded = 0, displayed = 0;
  const Json state = studio.state("state.json");
  for (const Json& message : state["messages"]) {
    const bool is_about_welding = message["text"].get<std::string>().find("welded 8") != std::string::npos;
    welded += is_about_welding ? 1 : 0;
    displayed += message["shown"].get<bool>() ? 1 : 0;
    EXPECT_FALSE(is_about_welding && message["shown"].get<bool>());
  }
  EXPECT_EQ(welded, 1) << studio.state("state.json")["messages"];
  EXPECT_EQ(displayed, 1) << "the assumed unit";
}

}  // namespace
}  // namespace taxel::test
