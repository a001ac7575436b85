// Open files that another program changes, replaces or deletes.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>
#include <thread>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "script_lines.h"
#include "virtual_screen.h"

namespace taxel::test {
namespace {

using namespace std::chrono_literals;

const std::string kSelect3 = click(taxel(3));
const Lines kRadius3{kSelect3, kIdle, key("f"), type("3"), kIdle, key("Enter"), kIdle};
/// Turns the camera, so that a test can check that the camera is kept.
const Lines kTurn{R"({"event": "wheel", "at": {"view": [0.413, 0.621]}, "y": 2})", kIdle};

std::string noticed(const std::string& text) {
  return R"({"do": "wait_for", "pointer": "/notices", "contains": ")" + text + R"("})";
}

/// Plays a script. As soon as the script has dumped "opened.json", the files are changed.
void play_while(const StudioProgram& studio, const Lines& lines, const std::string& file,
                const std::function<void()>& change) {
  Lines settled;  // a reported change is drawn in the next frame
  for (const std::string& line : lines) {
    settled.push_back(line);
    if (line.find("wait_for") != std::string::npos) settled.push_back(kIdle);
  }
  auto played = std::async(std::launch::async, [&] { return studio.run(settled, {file}); });
  const auto opened = studio.folder() / "opened.json";
  while (!std::filesystem::exists(opened) && played.wait_for(20ms) != std::future_status::ready) continue;
  change();
  const Outcome outcome = played.get();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

/// A layout and its mesh in the test's folder.
struct OwnFiles {
  explicit OwnFiles(const StudioProgram& studio) : folder(studio.folder()) {
    std::filesystem::copy_file(kMeshFile, folder / "finger.obj");
    document = Json::parse(file_text(kLayoutFile));
    document["mesh"] = {{"file", "finger.obj"}, {"scale", {1, 1, 1}}};
    document["sampling"]["density"] = 1e6;
    write();
  }
  void write() const {
    write_text(folder / "part", document.dump());
    std::filesystem::rename(folder / "part", layout());
  }
  /// Writes the finger, scaled by `factor`.
  void write_mesh(double factor) const {
    const TriMesh finger = *load_mesh(kMeshFile).mesh;
    std::vector<dvec3> vertices = finger.vertices();
    for (dvec3& v : vertices) v *= factor;
    save_mesh(folder / "finger.obj", TriMesh(vertices, finger.faces()));
  }
  [[nodiscard]] std::string layout() const { return (folder / "finger.taxels.json").string(); }
  std::filesystem::path folder;
  Json document;
};

double radius(const Json& state, int id) {
  return taxel_of(state["document"]["layout"], id)["radius"];
}

double farthest(const Json& state, const std::filesystem::path& mesh) {
  const MeshIndex skin(load_mesh(mesh).mesh);
  double largest = 0;
  for (const Json& taxel : state["document"]["layout"]["taxels"])
    largest = std::max(largest, skin.closest_point(vector_of(taxel["center"])).distance);
  return largest;
}

TEST(FileNotice, LeavesWhenTheFileIsBackAsItWas) {
  const StudioProgram studio;
  const OwnFiles own(studio);
  play_while(studio,
             {kIdle, key("Space"), kIdle, dump("opened.json"), noticed("was deleted"), dump("seen.json"),
              R"({"do": "wait_for", "pointer": "/notices", "equals": []})", dump("back.json")},
             own.layout(), [&] {
               std::filesystem::rename(own.layout(), own.folder / "away");
               EXPECT_TRUE(holds_within(60, [&] { return std::filesystem::exists(own.folder / "seen.json"); }));
               std::filesystem::rename(own.folder / "away", own.layout());
             });
  EXPECT_EQ(studio.state("seen.json")["notices"].size(), 1U);
  EXPECT_TRUE(studio.state("back.json")["notices"].empty());
}

TEST(FileWatch, ReadsAChangedLayoutAsAStepOfTheHistory) {
  const StudioProgram studio;
  OwnFiles files(studio);
  const Lines reload{noticed("changed by another"),
                     dump("noticed.json"),
                     R"({"do": "screenshot", "file": "noticed.png"})",
                     press("Read it again"),
                     kIdle,
                     dump("reloaded.json"),
                     key("z", kCtrl),
                     kIdle,
                     dump("undone.json"),
                     key("y", kCtrl),
                     kIdle,
                     dump("redone.json")};
  play_while(studio, joined({{kLayoutMode, kIdle}, kRadius3, kTurn, {dump("opened.json")}, reload}), files.layout(),
             [&] {
               files.document["taxels"][5]["radius"] = 0.004;
               files.write();
             });
  const Json opened = studio.state("opened.json"), told = studio.state("noticed.json"),
             reloaded = studio.state("reloaded.json"), undone = studio.state("undone.json");
  const int id = files.document["taxels"][5]["id"];
  ASSERT_EQ(told["notices"].size(), 1U);
  EXPECT_EQ(told["document"]["layout"], opened["document"]["layout"]) << "nothing happens unasked";
  EXPECT_EQ(radius(reloaded, id), 0.004);
  EXPECT_EQ(radius(reloaded, 3), 0.006) << "as the file has it";
  EXPECT_EQ(reloaded["history"]["depth"], 2);
  EXPECT_FALSE(reloaded["history"]["dirty"]);
  EXPECT_TRUE(reloaded["notices"].empty());
  EXPECT_EQ(reloaded["camera"], opened["camera"]);
  EXPECT_EQ(reloaded["selection"], opened["selection"]);
  EXPECT_EQ(reloaded["mode"], "layout");
  EXPECT_EQ(undone["document"]["layout"], opened["document"]["layout"]) << "the edit is there again";
  EXPECT_EQ(studio.state("redone.json")["document"]["layout"], reloaded["document"]["layout"]);
}

TEST(FileWatch, ReadsAChangedSceneAndKeepsTheView) {
  const StudioProgram studio;
  const auto scene = [&](const char* size) {
    write_text(studio.folder() / "part",
               std::string("<mujoco><worldbody><body><freejoint/><geom name='thing' type='box' "
                           "size='.02 .02 ") +
                   size + "'/></body></worldbody></mujoco>");
    std::filesystem::rename(studio.folder() / "part", studio.folder() / "scene.xml");
  };
  scene(".02");
  play_while(studio,
             joined({{kIdle, key("Space"), kIdle},
                     kTurn,
                     {dump("opened.json"), noticed("scene.xml was changed by another"), dump("noticed.json"),
                      press("Read it again"), kIdle, kIdle, dump("reloaded.json")}}),
             "scene.xml", [&] { scene(".04"); });
  const Json opened = studio.state("opened.json"), told = studio.state("noticed.json"),
             reloaded = studio.state("reloaded.json");
  EXPECT_EQ(told["simulation"]["step"], opened["simulation"]["step"]) << "nothing happens unasked";
  EXPECT_EQ(told["scene"]["geoms"], opened["scene"]["geoms"]);
  EXPECT_EQ(reloaded["simulation"]["step"], 0);
  EXPECT_EQ(reloaded["simulation"]["playing"], false);
  EXPECT_EQ(reloaded["camera"], opened["camera"]);
  EXPECT_EQ(reloaded["mode"], "simulate");
  EXPECT_TRUE(reloaded["notices"].empty());
}

TEST(FileWatch, WatchesFilesThatASceneIncludes) {
  const StudioProgram studio;
  const auto part = [&](const char* size) {
    write_text(studio.folder() / "new part",
               std::string("<mujoco><worldbody><body><freejoint/><geom name='thing' type='box' size='.02 .02 ") + size +
                   "'/></body></worldbody></mujoco>");
    std::filesystem::rename(studio.folder() / "new part", studio.folder() / "part.xml");
  };
  part(".02");
  save_mesh(studio.folder() / "thing.obj", *load_mesh(kMeshFile).mesh);
  write_text(studio.folder() / "scene.xml",
             "<mujoco><include file='part.xml'/><asset><mesh name='tip' file='thing.obj'/></asset>"
             "<worldbody><body pos='.1 0 0'><geom name='tip' type='mesh' mesh='tip'/></body></worldbody></mujoco>");
  const auto picture = [](const char* name) {
    return R"({"do": "screenshot", "file": ")" + std::string(name) + R"("})";
  };
  play_while(
      studio,
      joined({{kIdle, key("Space"), kIdle},
              kTurn,
              {picture("opened.png"), dump("opened.json"), noticed("part.xml, which scene.xml uses, was changed"),
               noticed("thing.obj, which scene.xml uses, was deleted"), dump("noticed.json"), press("Read it again"),
               kIdle, kIdle, dump("failed.json")}}),
      "scene.xml", [&] {
        part(".04");
        std::filesystem::remove(studio.folder() / "thing.obj");
      });
  const Json opened = studio.state("opened.json"), told = studio.state("noticed.json"),
             failed = studio.state("failed.json");
  EXPECT_EQ(told["simulation"]["step"], opened["simulation"]["step"]) << "nothing happens unasked";
  ASSERT_EQ(told["notices"].size(), 2U);
  EXPECT_NE(failed["messages"].dump().find("thing.obj"), std::string::npos) << "it cannot be read any more, and";
  EXPECT_EQ(failed["scene"]["geoms"], opened["scene"]["geoms"]) << "the scene stays open as it was";
}

TEST(FileWatch, ReadsTheChangedIncludeOfAScene) {
  const StudioProgram studio;
  const auto part = [&](const char* name) {
    write_text(studio.folder() / "new part",
               "<mujoco><worldbody><geom name='" + std::string(name) + "' size='.02'/></worldbody></mujoco>");
    std::filesystem::rename(studio.folder() / "new part", studio.folder() / "part.xml");
  };
  part("before");
  write_text(studio.folder() / "scene.xml", "<mujoco><include file='part.xml'/><worldbody/></mujoco>");
  play_while(studio,
             joined({{kIdle, key("Space"), kIdle},
                     kTurn,
                     {dump("opened.json"), noticed("part.xml, which scene.xml uses, was changed"),
                      press("Read it again"), kIdle, kIdle, dump("reloaded.json")}}),
             "scene.xml", [&] { part("after"); });
  const Json opened = studio.state("opened.json"), reloaded = studio.state("reloaded.json");
  EXPECT_EQ(opened["scene"]["geoms"][0]["name"], "before");
  EXPECT_EQ(reloaded["scene"]["geoms"][0]["name"], "after");
  EXPECT_EQ(reloaded["camera"], opened["camera"]);
  EXPECT_TRUE(reloaded["notices"].empty());
}

TEST(FileWatch, DoesNotReportAFileWrittenWithTheSameBytes) {
  const StudioProgram studio;
  OwnFiles files(studio);
  play_while(studio, {kIdle, dump("opened.json"), noticed("deleted"), dump("state.json")}, files.layout(), [&] {
    files.write();  // the same bytes
    std::this_thread::sleep_for(300ms);
    std::filesystem::remove(files.folder / "finger.obj");
  });
  const Json notices = studio.state("state.json")["notices"];
  ASSERT_EQ(notices.size(), 1U) << notices.dump();
  EXPECT_NE(notices[0]["text"].get<std::string>().find("finger.obj"), std::string::npos);
}

TEST(FileWatch, KeepsAPausedSimulationInAReload) {
  const StudioProgram studio;
  OwnFiles files(studio);
  play_while(studio,
             {kIdle, R"({"do": "wait_time", "time": 1.0})", key("Space"), kIdle, dump("opened.json"),
              noticed("changed by another"), press("Read it again"), kIdle, dump("reloaded.json")},
             files.layout(), [&] {
               files.document["taxels"][4]["radius"] = 0.003;  // the tip, which touches
               files.write();
             });
  const Json opened = studio.state("opened.json"), reloaded = studio.state("reloaded.json");
  EXPECT_EQ(reloaded["mode"], "simulate");
  EXPECT_FALSE(reloaded["simulation"]["playing"]);
  EXPECT_EQ(reloaded["simulation"]["step"], opened["simulation"]["step"]);
  EXPECT_EQ(reloaded["camera"], opened["camera"]);
  EXPECT_NE(reloaded["simulation"]["readings"], opened["simulation"]["readings"]) << "by the new layout";
}

TEST(FileWatch, SavesADeletedProjectAgain) {
  const StudioProgram studio;
  OwnFiles files(studio);
  const std::string project = (studio.folder() / "mine.taxelproj").string();
  studio.play(joined({{kLayoutMode, kIdle}, {key("s", kCtrl), kIdle, type(project), kIdle, key("Enter"), kIdle}}),
              {files.layout()});
  const std::string before = file_text(project);
  play_while(studio,
             {kIdle, dump("opened.json"), noticed("deleted"), dump("noticed.json"), key("s", kCtrl), kIdle,
              dump("saved.json")},
             project, [&] { std::filesystem::remove(project); });
  const Json told = studio.state("noticed.json"), saved = studio.state("saved.json");
  EXPECT_FALSE(studio.state("opened.json")["history"]["dirty"]);
  EXPECT_TRUE(told["history"]["dirty"]) << "it is on no disk any more";
  EXPECT_EQ(told["document"], studio.state("opened.json")["document"]);
  EXPECT_FALSE(saved["history"]["dirty"]);
  EXPECT_TRUE(saved["notices"].empty());
  EXPECT_EQ(Json::parse(file_text(project))["layout"], Json::parse(before)["layout"]);
}

TEST(FileWatch, AsksBeforeSavingOverAnotherProgramsChange) {
  const StudioProgram studio;
  OwnFiles files(studio);
  const std::string project = (studio.folder() / "mine.taxelproj").string();
  studio.play(joined({{kLayoutMode, kIdle}, {key("s", kCtrl), kIdle, type(project), kIdle, key("Enter"), kIdle}}),
              {files.layout()});
  Json theirs = Json::parse(file_text(project));
  theirs["layout"]["name"] = "theirs";
  play_while(studio,
             joined({{kIdle},
                     kRadius3,
                     {dump("opened.json"), noticed("changed by another"), key("s", kCtrl), kIdle, dump("asked.json"),
                      key("Esc"), kIdle}}),
             project, [&] { write_text(project, theirs.dump()); });
  EXPECT_NE(studio.state("asked.json")["widgets"].dump().find("\"Path\""), std::string::npos) << "the dialog is open";
  EXPECT_EQ(Json::parse(file_text(project))["layout"]["name"], "theirs");
}

TEST(FileWatch, MeasuresAReplacedMeshAndProjectsTheTaxelsOntoIt) {
  const StudioProgram studio;
  OwnFiles files(studio);
  play_while(studio,
             {kLayoutMode, kIdle, dump("opened.json"), noticed("replaced by another mesh"), dump("noticed.json"),
              R"({"do": "screenshot", "file": "replaced.png"})", press("Use it, taxels onto its surface"), kIdle,
              dump("moved.json"), key("z", kCtrl), kIdle, dump("undone.json")},
             files.layout(), [&] { files.write_mesh(1.1); });
  const Json opened = studio.state("opened.json"), told = studio.state("noticed.json"),
             moved = studio.state("moved.json"), undone = studio.state("undone.json");
  ASSERT_EQ(told["notices"].size(), 1U);
  const auto text = told["notices"][0]["text"].get<std::string>();
  char far[32];
  std::snprintf(far, sizeof far, "%.3g mm", 1e3 * farthest(opened, files.folder / "finger.obj"));
  EXPECT_NE(text.find(std::string("the farthest with ") + far), std::string::npos) << text;
  EXPECT_EQ(told["document"], opened["document"]) << "nothing happens unasked";
  EXPECT_LT(farthest(moved, files.folder / "finger.obj"), 1e-9);
  EXPECT_EQ(moved["history"]["depth"], opened["history"]["depth"].get<int>() + 1) << "mesh and taxels are one step";
  EXPECT_NEAR(moved["document"]["mesh"]["size"][0].get<double>(),
              1.1 * opened["document"]["mesh"]["size"][0].get<double>(), 1e-9);
  EXPECT_EQ(undone["document"]["layout"], opened["document"]["layout"]);
  EXPECT_EQ(undone["document"]["mesh"], opened["document"]["mesh"]) << "the mesh that there was, not that of the file";
}

TEST(FileWatch, SavesADocumentWithItsDeletedMesh) {
  const StudioProgram studio;
  OwnFiles files(studio);
  std::filesystem::create_directories(studio.folder() / "kept");
  const std::string project = (studio.folder() / "kept" / "mine.taxelproj").string();
  play_while(studio,
             {kLayoutMode, kIdle, dump("opened.json"), noticed("deleted"), key("s", kCtrl), kIdle, type(project), kIdle,
              key("Enter"), kIdle, dump("saved.json")},
             files.layout(), [&] { std::filesystem::remove(files.folder / "finger.obj"); });
  EXPECT_FALSE(studio.state("saved.json")["history"]["dirty"]);
  studio.play({kIdle, dump("again.json")}, {project});
  const Json opened = studio.state("opened.json"), again = studio.state("again.json");
  EXPECT_EQ(again["document"]["layout"]["taxels"], opened["document"]["layout"]["taxels"]);
  EXPECT_EQ(again["document"]["mesh"]["triangles"], opened["document"]["mesh"]["triangles"]);
  EXPECT_TRUE(again["notices"].empty());
}

TEST(FileWatch, ReportsAForeignMeshWhenALayoutOpens) {
  const StudioProgram studio;
  OwnFiles files(studio);
  files.document["mesh"]["sha256"] = std::string(64, '0');
  files.write();
  studio.play({kLayoutMode, kIdle, dump("noticed.json"), press("Use this mesh"), kIdle, dump("taken.json")},
              {files.layout()});
  const Json told = studio.state("noticed.json"), taken = studio.state("taken.json");
  ASSERT_EQ(told["notices"].size(), 1U);
  EXPECT_NE(told["notices"][0]["text"].get<std::string>().find("12 taxels lie"), std::string::npos);
  EXPECT_TRUE(taken["notices"].empty());
  EXPECT_NE(taken["document"]["layout"]["mesh"]["sha256"], std::string(64, '0'));
  EXPECT_EQ(taken["document"]["layout"]["taxels"], told["document"]["layout"]["taxels"]);
}

TEST(FileWatch, ReportsABrokenMeshAndKeepsTheOpenOne) {
  const StudioProgram studio;
  OwnFiles files(studio);
  play_while(studio, {kLayoutMode, kIdle, dump("opened.json"), noticed("cannot be read now"), dump("noticed.json")},
             files.layout(), [&] { write_text(files.folder / "finger.obj", "v 0 0 0\n"); });
  EXPECT_EQ(studio.state("noticed.json")["document"], studio.state("opened.json")["document"]);
}

TEST(FileWatch, KeepsTaxelsIfAMeshOpenedAloneIsReadAgain) {
  const StudioProgram studio;
  OwnFiles files(studio);
  const std::string place = click(R"({"world": [0.0083, 0.0007, 0.0194]})", kCtrl);
  play_while(studio,
             {kIdle, place, kIdle, dump("opened.json"), noticed("replaced by another mesh"), key("l", kCtrl), kIdle,
              dump("reloaded.json")},
             (files.folder / "finger.obj").string(), [&] { files.write_mesh(1.05); });
  const Json opened = studio.state("opened.json"), reloaded = studio.state("reloaded.json");
  EXPECT_EQ(reloaded["document"]["layout"]["taxels"], opened["document"]["layout"]["taxels"]);
  EXPECT_NEAR(reloaded["document"]["mesh"]["size"][0].get<double>(),
              1.05 * opened["document"]["mesh"]["size"][0].get<double>(), 1e-9);
  EXPECT_TRUE(reloaded["notices"].empty()) << "it was answered";
}

}  // namespace
}  // namespace taxel::test
