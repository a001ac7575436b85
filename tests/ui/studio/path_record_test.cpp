// Paths made by moving the tool: recorded while a scenario or the mouse moves the tool, and waypoints moved by G with
// axes and numbers.
#include <gtest/gtest.h>

#include "scenario_lines.h"

namespace taxel::test {
namespace {

/// Paused with the scenario in the inspector.
const Lines kStill = joined({kScenarioAlone, {key("Space"), kIdle}});
const std::string kRecord = press("Inspector/Record path");
const std::string kOver = R"({"do": "wait_for", "pointer": "/simulation/finished", "equals": true})";

std::string mouse_at(const std::string& event, const dvec2& at, const std::string& button, const Json& mods) {
  Json line{{"event", event}, {"at", {at.x, at.y}}};
  if (event != "mouse_move") line["button"] = button, line["mods"] = mods;
  return line.dump();
}
double largest_of(const Json& peaks) {
  double largest = 0;
  for (const Json& peak : peaks) largest = std::max(largest, peak.get<double>());
  return largest;
}

TEST(PathRecording, TurnsAScenarioIntoAPathThatRepeatsIt) {
  const StudioProgram studio;
  studio.play(joined({kStill,
                      choose_kind("press"),
                      typed_in_inspector("Hold (s)", "0.2"),
                      {dump("before.json"), kRecord, kIdle},
                      kRunScenario,
                      {dump("recording.json"), kOver, kIdle, dump("path.json")},
                      kRunScenario,
                      {kOver, kIdle, dump("played.json"), R"({"do": "screenshot", "file": "path.png"})",
                       key("z", kCtrl), kIdle, dump("undone.json")}}),
              coarse_fingertip(studio));
  const Json before = studio.state("before.json"), path = studio.state("path.json"),
             played = studio.state("played.json");
  EXPECT_EQ(before["scenario"]["recorded"], nullptr);
  EXPECT_GE(studio.state("recording.json")["scenario"]["recorded"].get<int>(), 1);
  EXPECT_EQ(path["scenario"]["recorded"], nullptr) << "it ends with the run";
  const Json& edited = path["scenario"]["edited"];
  ASSERT_EQ(edited["kind"], "path");
  const Json& points = edited["points"];
  ASSERT_GT(points.size(), 5U);
  EXPECT_EQ(points[0]["time"], 0);
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    EXPECT_GE(points[i]["time"].get<double>() - points[i - 1]["time"].get<double>(), 0.05 - 1e-9) << i;
  EXPECT_NEAR(points.back()["time"].get<double>(), path["simulation"]["time"].get<double>(), 0.021);
  EXPECT_LT(glm::distance(vector_of(points.back()["pos"]), vector_of(path["simulation"]["sensors"][0]["position"])),
            1e-4)
      << "it lags a little";
  EXPECT_EQ(path["history"]["depth"].get<int>(), before["history"]["depth"].get<int>() + 1) << "one step";
  EXPECT_EQ(played["scenario"]["running"], edited);
  const double pressed = largest_of(path["simulation"]["peaks"]), again = largest_of(played["simulation"]["peaks"]);
  EXPECT_GT(pressed, 1000);
  EXPECT_NEAR(again, pressed, 0.05 * pressed) << "the finger is led the same way";
  EXPECT_EQ(studio.state("undone.json")["scenario"]["edited"], before["scenario"]["edited"]);
}

/// The box of the paper's demo begins at (-15, -25, -12) mm, boxes of all other scenarios at (0, -25, 0) mm.
TEST(PathRecording, MovesThePapersPathWithItsBox) {
  const StudioProgram studio;
  studio.play(joined({kStill,
                      choose_kind("paper"),
                      {kRecord, kIdle},
                      kRunScenario,
                      {R"({"do": "wait_time", "time": 0.5})", key("Space"), kIdle, dump("run.json"), kRecord, kIdle,
                       dump("path.json")},
                      kRunScenario,
                      {key("Space"), kIdle, dump("played.json")}}),
              coarse_fingertip(studio));
  const Json run = studio.state("run.json"), path = studio.state("path.json"), played = studio.state("played.json");
  const Json& edited = path["scenario"]["edited"];
  ASSERT_EQ(edited["kind"], "path") << path["messages"].dump();
  const dvec3 box_moved(0.015, 0, 0.012);
  const Json& points = edited["points"];
  ASSERT_GT(points.size(), 4U);
  const dvec3 finger = vector_of(run["simulation"]["sensors"][0]["position"]);
  EXPECT_LT(glm::distance(vector_of(points.back()["pos"]), finger + box_moved), 1e-4) << "it lags a little";
  EXPECT_EQ(played["scenario"]["running"], edited);
  EXPECT_EQ(played["scenario"]["running"].value("shape", "box"), "box");
}

TEST(PathRecording, RecordsTheMouseWhileTheSimulationIsPaused) {
  const StudioProgram studio;
  const Json ctrl = {"ctrl"};
  Lines drag{mouse_at("mouse_down", {500, 300}, "right", ctrl)};
  for (int i = 1; i <= 12; ++i)
    drag.push_back(mouse_at("mouse_move", {500 + 5 * i, 300 - 2 * i}, "right", ctrl)), drag.push_back(kIdle);
  drag.push_back(dump("led.json"));
  drag.push_back(mouse_at("mouse_up", {560, 276}, "right", ctrl));
  studio.play(joined({kStill,
                      {dump("open.json"), R"({"event": "double_click", "button": "left", "at": {"taxel": 1}})", kIdle,
                       kIdle, kRecord, kIdle},
                      drag,
                      {kIdle, dump("still.json"), kIdle, kIdle, kRecord, kIdle, dump("path.json")},
                      kRunScenario,
                      {R"({"do": "wait_time", "time": 0.1})", key("Space"), kIdle, dump("played.json")}}),
              coarse_fingertip(studio));
  const Json open = studio.state("open.json"), led = studio.state("led.json"), path = studio.state("path.json");
  ASSERT_NE(led["simulation"]["sensors"], open["simulation"]["sensors"]) << "the finger follows the mouse";
  const Json& points = path["scenario"]["edited"]["points"];
  ASSERT_GT(points.size(), 4U) << path["messages"].dump();
  EXPECT_EQ(points[0]["pos"], open["simulation"]["sensors"][0]["position"]);
  EXPECT_EQ(points.back()["pos"], led["simulation"]["sensors"][0]["position"]);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_GT(points[i]["time"].get<double>(), points[i - 1]["time"].get<double>());
  EXPECT_EQ(path["history"]["depth"], 1);
  EXPECT_EQ(studio.state("played.json")["scenario"]["running"]["points"], points);
}

TEST(PathRecording, ChangesNothingIfNothingMoved) {
  const StudioProgram studio;
  studio.play(joined({kStill,
                      {kRecord, kIdle, kIdle, kRecord, kIdle, dump("still.json")},
                      typed_in_inspector("Way point every", "0"),
                      {dump("refused.json")}}),
              coarse_fingertip(studio));
  const Json still = studio.state("still.json");
  EXPECT_FALSE(still["scenario"]["edited"].contains("kind")) << "a sweep";
  EXPECT_EQ(still["history"]["depth"], 0);
  EXPECT_NE(still["messages"].dump().find("did not move"), std::string::npos);
  EXPECT_EQ(studio.state("refused.json")["refused"]["field"], "Way point every");
}

TEST(WayPoints, AreMovedByPointerAxisAndNumber) {
  const StudioProgram studio;
  const auto layout = coarse_fingertip(studio);
  const Lines start = joined({kStill, choose_kind("path"), {press("Inspector/Way point 1"), kIdle, dump("path.json")}});
  studio.play(joined({start,
                      {R"({"event": "mouse_move", "at": {"view": [0.265, 0.346]}})",
                       kIdle,
                       key("g"),
                       kIdle,
                       key("x"),
                       kIdle,
                       type("2.5"),
                       kIdle,
                       dump("typing.json"),
                       R"({"do": "screenshot", "file": "g.png"})",
                       key("Enter"),
                       kIdle,
                       dump("x.json"),
                       key("g"),
                       kIdle,
                       key("z"),
                       kIdle,
                       R"({"event": "mouse_move", "at": {"view": [0.265, 0.288]}})",
                       kIdle,
                       dump("pulling.json"),
                       key("Escape"),
                       kIdle,
                       dump("restored.json"),
                       key("g"),
                       kIdle,
                       key("z"),
                       kIdle,
                       R"({"event": "mouse_move", "at": {"view": [0.265, 0.229]}})",
                       kIdle,
                       click(in_view(0.265, 0.229)),
                       kIdle,
                       dump("z.json"),
                       key("z", kCtrl),
                       kIdle,
                       key("z", kCtrl),
                       kIdle,
                       dump("undone.json"),
                       key("g"),
                       kIdle,
                       key("Enter"),
                       kIdle,
                       dump("nothing.json")}}),
              layout);
  const auto point = [&](const char* file, std::size_t i) -> Json {
    return studio.state(file)["scenario"]["edited"]["points"][i];
  };
  const dvec3 at = vector_of(point("path.json", 1)["pos"]);
  const auto depth = [&](const char* file) { return studio.state(file)["history"]["depth"].get<int>(); };
  EXPECT_EQ(studio.state("typing.json")["tool"]["name"], "way_point");
  EXPECT_EQ(studio.state("typing.json")["tool"]["value"], "2.500 mm along X");
  EXPECT_EQ(vector_of(point("x.json", 1)["pos"]), at + dvec3(0.0025, 0, 0));
  EXPECT_EQ(point("x.json", 0), point("path.json", 0));
  EXPECT_EQ(point("x.json", 1)["quat"], point("path.json", 1)["quat"]);
  EXPECT_EQ(depth("x.json"), depth("path.json") + 1) << "typed digit by digit, it is one step";
  const dvec3 pulled = vector_of(point("pulling.json", 1)["pos"]), base = vector_of(point("x.json", 1)["pos"]);
  EXPECT_GT(pulled.z, base.z + 1e-4);
  EXPECT_EQ(dvec2(pulled), dvec2(base));
  EXPECT_EQ(point("restored.json", 1), point("x.json", 1)) << "bit for bit";
  EXPECT_EQ(depth("restored.json"), depth("x.json"));
  EXPECT_GT(vector_of(point("z.json", 1)["pos"]).z, base.z + 1e-4);
  EXPECT_EQ(depth("z.json"), depth("x.json") + 1);
  EXPECT_EQ(studio.state("z.json")["selection"], studio.state("path.json")["selection"]) << "the click only accepts";
  EXPECT_EQ(studio.state("z.json")["camera"], studio.state("path.json")["camera"]);
  EXPECT_EQ(point("undone.json", 1), point("path.json", 1));
  EXPECT_EQ(depth("nothing.json"), depth("undone.json")) << "nothing was moved";
}

}  // namespace
}  // namespace taxel::test
