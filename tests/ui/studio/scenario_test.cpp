// Scenarios in the window: each kind is chosen, edited and run in the inspector, and a path's waypoints are moved with
// the mouse.
#include <gtest/gtest.h>

#include "app/studio/nouns/timeline/run_commands.h"
#include "scenario_lines.h"

namespace taxel::test {
namespace {

std::string until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}

TEST(Scenario, IsEditedInTheDocumentByKindAndValues) {
  const StudioProgram studio;
  studio.play(joined({kScenarioAlone,
                      {key("Space"), dump("sweep.json")},
                      choose_kind("twist"),
                      typed_in_inspector("Angle (\u00b0)", "20"),
                      {dump("twist.json")},
                      kRunScenario,
                      {until(0.3), key("Space"), kIdle, dump("run.json"), key("z", kCtrl), kIdle, dump("undone.json"),
                       key("z", kCtrl), kIdle, dump("back.json")}}),
              coarse_fingertip(studio));
  const Json twist = studio.state("twist.json"), run = studio.state("run.json"), back = studio.state("back.json");
  EXPECT_EQ(twist["scenario"]["edited"]["kind"], "twist");
  EXPECT_EQ(twist["scenario"]["edited"]["angle_deg"], 20);
  EXPECT_EQ(twist["scenario"]["running"], studio.state("sweep.json")["scenario"]["edited"]);
  EXPECT_EQ(twist["history"]["undo"], "Undo Change the scenario");
  EXPECT_EQ(run["scenario"]["running"], twist["scenario"]["edited"]);
  EXPECT_NE(run["simulation"]["title"].get<std::string>().find("twist"), std::string::npos);
  EXPECT_EQ(studio.state("undone.json")["scenario"]["edited"]["angle_deg"], 30);
  EXPECT_EQ(back["scenario"]["edited"], studio.state("sweep.json")["scenario"]["edited"]);
  EXPECT_TRUE(back["history"]["compiled"].get<bool>());
  EXPECT_EQ(back["history"]["depth"], 0);
}

TEST(Scenario, RunsForEveryKind) {
  const StudioProgram studio;
  const auto running = [](const std::string& kind, const Lines& more) {
    return joined({choose_kind(kind),
                   more,
                   kRunScenario,
                   {until(0.05), key("Space"), kIdle, dump(kind + ".json"), key("Space"), kIdle}});
  };
  std::vector<std::string> kinds{"press", "roll", "twist", "slide", "drop", "path", "paper"};
  Lines lines = kScenarioAlone;
  for (const std::string& kind : kinds) lines = joined({lines, running(kind, {})});
#ifdef TAXEL_PROGRAM
  write_text(studio.folder() / "slide.json", R"({"kind": "slide", "distance": 0.001})");
  const Outcome played = run_program(
      TAXEL_PROGRAM, {"play", "slide.json", "--density", "1e5", "--out", "slid", "--quiet"}, studio.folder());
  ASSERT_EQ(played.status, 0) << played.err;
  lines = joined({lines, running("replay", typed_in_inspector("Recording", "slid"))});
  kinds.push_back("replay");
#endif
  studio.play(lines, coarse_fingertip(studio));
  for (const std::string& kind : kinds) {
    const Json state = studio.state(kind + ".json");
    EXPECT_EQ(state["scenario"]["running"]["kind"], kind);
    EXPECT_GE(state["simulation"]["time"], 0.04) << kind;
    EXPECT_NE(state["simulation"]["title"].get<std::string>().find(kind), std::string::npos);
    for (const Json& message : state["messages"]) EXPECT_NE(message["severity"], "error") << message.dump();
  }
}

#ifdef TAXEL_PROGRAM
TEST(Scenario, RunsOnTheLayoutOfARecordedRun) {
  const StudioProgram studio;
  write_text(studio.folder() / "slide.json", R"({"kind": "slide", "distance": 0.001})");
  const Outcome played = run_program(
      TAXEL_PROGRAM, {"play", "slide.json", "--density", "1e5", "--out", "slid", "--quiet"}, studio.folder());
  ASSERT_EQ(played.status, 0) << played.err;
  studio.play({until(0.05), key("Space"), kIdle, dump("run.json")},
              {"--scenario", "slid/scenario.json", "slid/finger.taxels.json"});
  const Json run = studio.state("run.json");
  EXPECT_EQ(run["scenario"]["running"]["kind"], "slide");
  EXPECT_EQ(run["scenario"]["running"]["distance"], 0.001);
  EXPECT_EQ(run["document"]["layout"]["sampling"]["density"], 1e5);
}
#endif

TEST(Scenario, GetsThePaperSettingInOneEdit) {
  const StudioProgram studio;
  studio.play(
      joined({kScenarioAlone,
              {key("Space"), kIdle, dump("before.json"), press("Inspector/As in the paper"), kIdle, dump("paper.json")},
              kRunScenario,
              {until(0.05), key("Space"), kIdle, dump("run.json"), key("z", kCtrl), kIdle, dump("undone.json")}}),
      coarse_fingertip(studio));
  const Json before = studio.state("before.json"), paper = studio.state("paper.json");
  EXPECT_EQ(paper["scenario"]["edited"]["kind"], "paper");
  EXPECT_EQ(paper["history"]["undo"], "Undo Set up as in the paper");
  EXPECT_EQ(paper["history"]["depth"].get<int>(), before["history"]["depth"].get<int>() + 1);
  EXPECT_EQ(studio.state("run.json")["scenario"]["running"]["kind"], "paper");
  EXPECT_EQ(studio.state("undone.json")["scenario"]["edited"], before["scenario"]["edited"]);
}

TEST(Scenario, CrossesAnEdgeByDefaultAndChangesObjectWithTheKind) {
  const StudioProgram studio;
  std::vector<std::string> arguments = coarse_fingertip(studio);
  arguments.insert(arguments.end(), {"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"});
  studio.play(joined({kScenarioAlone,
                      {until(2.4), key("Space"), kIdle, dump("edge.json")},
                      choose_kind("press"),
                      {dump("press.json"), key("z", kCtrl), kIdle, dump("undone.json")}}),
              arguments);
  const Json edge = studio.state("edge.json");
  EXPECT_EQ(edge["scenario"]["running"]["shape"], "edge");
  EXPECT_EQ(edge["scenario"]["running"]["before"], 0.025);
  EXPECT_FALSE(studio.state("press.json")["scenario"]["edited"].contains("shape")) << "a box";
  EXPECT_EQ(studio.state("undone.json")["scenario"]["edited"], edge["scenario"]["edited"]);
}

TEST(Scenario, WaitsForTheRecordingOfAReplay) {
  const StudioProgram studio;
  studio.play(joined({kScenarioAlone,
                      choose_kind("replay"),
                      {dump("chosen.json")},
                      typed_in_inspector("Recording", "nowhere"),
                      kRunScenario,
                      {dump("refused.json")}}),
              coarse_fingertip(studio));
  EXPECT_EQ(studio.state("chosen.json")["history"]["depth"], 0);
  const Json refused = studio.state("refused.json");
  EXPECT_EQ(refused["scenario"]["edited"]["source"], "nowhere");
  EXPECT_NE(refused["messages"].dump().find("nowhere: no such file"), std::string::npos);
  EXPECT_NE(refused["simulation"]["title"].get<std::string>().find("sweep"), std::string::npos) << "what ran goes on";
}

TEST(Scenario, KeepsValuesOutOfRangeInTheirField) {
  const StudioProgram studio;
  studio.play(
      joined({kScenarioAlone, choose_kind("press"), typed_in_inspector("Depth (mm)", "-1"), {dump("refused.json")}}),
      coarse_fingertip(studio));
  const Json state = studio.state("refused.json");
  EXPECT_EQ(state["scenario"]["edited"]["depth"], 0.0015);
  EXPECT_NE(state["refused"]["words"].get<std::string>().find("greater than 0"), std::string::npos) << state["refused"];
}

TEST(Scenario, HasWaypointsThatAreDraggedAddedDeletedAndTyped) {
  const StudioProgram studio;
  const auto layout = coarse_fingertip(studio);
  const Lines start =
      joined({kScenarioAlone, {until(0.2), key("Space"), kIdle}, choose_kind("path"), {kIdle, dump("path.json")}});
  studio.play(start, layout);
  const Json path = studio.state("path.json")["scenario"];
  ASSERT_EQ(path["edited"]["points"].size(), 2U) << "the ends of the sweep";
  ASSERT_EQ(path["way_points"].size(), 2U);
  const Json at = path["way_points"][1]["pixel"];
  const double x = at[0].get<double>(), y = at[1].get<double>();
  const auto pixel = [](double px, double py) { return Json({px, py}).dump(); };
  const auto mouse = [&](const std::string& event, double px, double py) {
    const std::string button = event == "mouse_move" ? "" : R"(, "button": "left")";
    return R"({"event": ")" + event + R"(", "at": )" + pixel(px, py) + button + "}";
  };
  studio.play(joined({start,
                      {mouse("mouse_move", x, y), mouse("mouse_down", x, y), mouse("mouse_move", x + 30, y - 10), kIdle,
                       mouse("mouse_move", x + 60, y - 40), kIdle, mouse("mouse_up", x + 60, y - 40), kIdle,
                       dump("dragged.json"), press("Inspector/Add here"), kIdle, dump("added.json"),
                       press("Inspector/Delete way point"), kIdle, dump("deleted.json")},
                      typed_in_inspector("Time 1", "9"),
                      {dump("typed.json"), key("z", kCtrl), key("z", kCtrl), key("z", kCtrl), key("z", kCtrl), kIdle,
                       dump("undone.json")}}),
              layout);
  const Json dragged = studio.state("dragged.json")["scenario"];
  EXPECT_EQ(dragged["selected"], 1);
  EXPECT_NEAR(dragged["way_points"][1]["pixel"][0].get<double>(), x + 60, 1);
  EXPECT_NEAR(dragged["way_points"][1]["pixel"][1].get<double>(), y - 40, 1);
  EXPECT_EQ(dragged["edited"]["points"][0], path["edited"]["points"][0]);
  EXPECT_EQ(studio.state("dragged.json")["camera"], studio.state("path.json")["camera"]);
  EXPECT_EQ(studio.state("dragged.json")["history"]["depth"].get<int>(),
            studio.state("path.json")["history"]["depth"].get<int>() + 1)
      << "a drag is one step";
  const Json added = studio.state("added.json");
  ASSERT_EQ(added["scenario"]["edited"]["points"].size(), 3U);
  EXPECT_EQ(added["scenario"]["edited"]["points"][2]["pos"], added["simulation"]["sensors"][0]["position"]);
  EXPECT_EQ(studio.state("deleted.json")["scenario"]["edited"]["points"], dragged["edited"]["points"]);
  EXPECT_EQ(studio.state("typed.json")["scenario"]["edited"]["points"][1]["time"], 9);
  EXPECT_EQ(studio.state("undone.json")["scenario"]["edited"], path["edited"]);
}

TEST(Scenario, IsKeptInASavedProject) {
  const StudioProgram studio;
  studio.play(joined({kScenarioAlone,
                      choose_kind("path"),
                      {key("s", kCtrl), kIdle, key("a", kCtrl), type("kept.taxelproj"), key("Enter"), kIdle,
                       dump("saved.json")}}),
              coarse_fingertip(studio));
  const Json saved = studio.state("saved.json");
  const Json file = Json::parse(file_text(studio.folder() / "kept.taxelproj"));
  EXPECT_EQ(file["scenario"], saved["scenario"]["edited"]);
  EXPECT_EQ(file["scenario"]["kind"], "path");
}

TEST(RunScenario, ReportsThatTaxelsAreMissing) {
  const StudioProgram studio;
  studio.play(
      {kIdle, kLayoutMode, kIdle, key("a"), kIdle, key("Delete"), kIdle, key("2", kCtrl), kIdle, dump("before.json"),
       press("Run scenario"), kIdle, dump("refused.json"), R"({"do": "screenshot", "file": "refused.png"})"},
      tall_window(studio));
  EXPECT_EQ(studio.state("before.json")["document"]["layout"]["taxels"].size(), 0U);
  const Json before = studio.state("before.json")["messages"], refused = studio.state("refused.json")["messages"];
  ASSERT_GT(refused.size(), 0U);
  EXPECT_NE(refused.dump(), before.dump());
  EXPECT_NE(refused[refused.size() - 1].dump().find("the layout has no taxels"), std::string::npos) << refused;
}

}  // namespace
}  // namespace taxel::test
