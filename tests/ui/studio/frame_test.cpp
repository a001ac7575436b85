// A saved step: another process displays the same step.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the numbers of a state that belong to the step and not to the camera.
Json of_the_step(const Json& state) {
  Json out = {{"time", state["simulation"]["time"]},
              {"travel", state["simulation"]["travel"]},
              {"sensors", state["simulation"]["sensors"]},
              {"polygons", Json::array()},
              {"bars", Json::array()}};
  for (Json polygon : state["polygons"]) {
    for (const char* of_the_camera : {"pixel", "depth", "facing", "inside"}) polygon.erase(of_the_camera);
    out["polygons"].push_back(polygon);
  }
  for (const Json& bar : state["bars"]) out["bars"].push_back({bar["taxel"], bar["value"]});
  return out;
}

Lines saved_at(double time, const std::string& file) {
  return joined({{R"({"do": "wait_time", "time": )" + std::to_string(time) + "}", key("Space"), kIdle},
                 {press("File"), kIdle, press("Export"), kIdle, press("Save this step..."), kIdle, type(file), kIdle,
                  key("Enter"), kIdle},
                 {dump("saved.json"), R"({"do": "screenshot", "file": "saved.png"})"}});
}

TEST(SavedStep, ShowsTheSameNumbersInAnotherProcess) {
  const StudioProgram studio;
  // Uses its own copy of the layout, which is removed before the step is opened elsewhere.
  const std::filesystem::path here = studio.folder() / "here", elsewhere = studio.folder() / "elsewhere";
  for (const auto& folder : {here, elsewhere}) std::filesystem::create_directory(folder);
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = "own.obj";
  layout["sampling"]["density"] = 1e6;
  std::filesystem::copy_file(kMeshFile, here / "own.obj");
  write_text(here / "own.taxels.json", layout.dump());
  const std::string nearer = R"({"event": "wheel", "at": {"widget": "View"}, "y": 3})";
  studio.play(joined({{nearer}, saved_at(1.2, (here / "press").string())}), {"here/own.taxels.json"});
  const std::string file = (elsewhere / "press").string();
  std::filesystem::copy_file(here / "press.taxelframe", file + ".taxelframe");
  std::filesystem::remove_all(here);
  studio.play({kIdle, dump("opened.json"), R"({"do": "screenshot", "file": "opened.png"})"}, {file + ".taxelframe"});
  const Json saved = studio.state("saved.json"), opened = studio.state("opened.json");
  EXPECT_GT(saved["polygons"].size(), 50U);
  EXPECT_EQ(of_the_step(opened), of_the_step(saved));
  EXPECT_EQ(opened["camera"], saved["camera"]);
  EXPECT_EQ(opened["mode"], "simulate");
  const std::string bytes = file_text(file + ".taxelframe");
  EXPECT_NE(bytes.find("state.json"), std::string::npos);
  EXPECT_NE(bytes.find("picture.png"), std::string::npos);
}

TEST(SavedStep, IsReadByOtherModelsLikeTheOriginalStep) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 2e5;
  write_text(studio.folder() / "few.taxels.json", layout.dump());
  const std::string file = (studio.folder() / "press").string();
  const Lines models{press("Panels"), kIdle, press("Models"), kIdle};
  studio.play(joined({saved_at(1.0, file), models, {dump("models.json")}}), {"few.taxels.json"});
  studio.play(joined({models, {dump("opened.json")}}), {file + ".taxelframe"});
  const Json saved = studio.state("models.json")["models"], opened = studio.state("opened.json")["models"];
  EXPECT_EQ(opened["step"], saved["step"]);
  for (const char* word : {"reading", "star", "weighted_sum", "exact", "tactile", "touch"}) {
    EXPECT_EQ(opened["models"][word]["missing"], "") << word;
    EXPECT_EQ(opened["models"][word]["values"].size(), 12U) << word;
    EXPECT_EQ(opened["models"][word]["values"], saved["models"][word]["values"]) << word;
  }
}

TEST(SavedStep, DoesNotRunAndReportsIt) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "press").string();
  studio.play(saved_at(1.0, file), {kLayoutFile});
  studio.play({kIdle, dump("before.json"), key("Space"), kIdle, key("Right"), kIdle, key("Left"), kIdle, kLayoutMode,
               kIdle, key("2", kCtrl), kIdle, dump("after.json")},
              {file + ".taxelframe"});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_EQ(of_the_step(after), of_the_step(before));
  EXPECT_NE(after["messages"].dump().find("single step"), std::string::npos);
  EXPECT_EQ(after["simulation"]["playing"], false);
}

TEST(SavedStep, IsRefusedByNameIfTheFileIsDamaged) {
  const StudioProgram studio;
  write_text(studio.folder() / "broken.taxelframe", "PK nothing");
  const Outcome outcome = studio.run({kIdle}, {"broken.taxelframe"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("broken.taxelframe"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace taxel::test
