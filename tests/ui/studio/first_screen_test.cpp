// The amount of widgets and words on the first screen, and how the panels that it leaves out are reached.
#include <gtest/gtest.h>

#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::set<std::string> panels_of(const Json& state) {
  std::set<std::string> panels;
  for (const Json& widget : state["widgets"]) panels.insert(widget["panel"].get<std::string>());
  return panels;
}

class FirstScreen : public testing::TestWithParam<const char*> {};

TEST_P(FirstScreen, HasAtMost60WidgetsAnd90Words) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.6), dump("first.json")}, {"--demo", "--size", GetParam()});
  const Json first = studio.state("first.json");
  EXPECT_LE(first["amount"]["widgets"], 60) << first["widgets"];
  EXPECT_LE(first["amount"]["words"], 90);
  EXPECT_GT(first["amount"]["words"], 30) << "the count sees the texts";
  EXPECT_GT(first["amount"]["numbers"], 10);
}

INSTANTIATE_TEST_SUITE_P(Sizes, FirstScreen, testing::Values("1280x800", "1920x1080"));

TEST(FirstScreenPanels, ComeByTheMenuAndWithTheEndOfTheDemo) {
  const Lines begin{kIdle, wait_time(0.5)};
  const StudioProgram studio;
  studio.play(
      joined(
          {begin, {dump("demo.json"), press("Panels"), kIdle, press("Inspector"), kIdle, kIdle, dump("asked.json")}}),
      {"--demo"});
  const Json demo = studio.state("demo.json"), asked = studio.state("asked.json");
  EXPECT_FALSE(panels_of(demo).contains("Inspector"));
  EXPECT_FALSE(panels_of(demo).contains("Timeline"));
  EXPECT_TRUE(demo["presentation"]["few_panels"]);
  EXPECT_TRUE(panels_of(asked).contains("Inspector")) << "the entry shows the panel, it does not close it";
  EXPECT_TRUE(panels_of(asked).contains("Timeline"));
  EXPECT_TRUE(asked["simulation"]["history"]["demo"]["runs"]) << "the demo goes on";

  studio.play(joined({begin,
                      {key("Space"), R"({"do": "wait_for", "pointer": "/presentation/few_panels", "equals": false})",
                       kIdle, kIdle, dump("paused.json")}}),
              {"--demo"});
  const std::set<std::string> paused = panels_of(studio.state("paused.json"));
  for (const char* panel : {"Inspector", "Taxels", "Timeline", "Pressure bars"})
    EXPECT_TRUE(paused.contains(panel)) << panel;
}

TEST(FirstScreenPanels, HaveInLayoutNoButtonsOfTheSimulation) {
  const StudioProgram studio;
  studio.play({kIdle, kLayoutMode, kIdle, kIdle, dump("layout.json"), key("x"), kIdle,
               R"({"event": "mouse_move", "at": {"taxel": 3}})", kIdle, kIdle, dump("probe.json")},
              {kLayoutFile});
  std::set<std::string> layout, probe;
  const Json without = studio.state("layout.json"), with = studio.state("probe.json");
  for (const Json& widget : without["widgets"])
    if (widget["panel"] == "Toolbar") layout.insert(widget["label"]);
  for (const Json& widget : with["widgets"])
    if (widget["panel"] == "Toolbar") probe.insert(widget["label"]);
  EXPECT_EQ(layout, (std::set<std::string>{"LAYOUT", "SIMULATE", "ANALYSE", "X-ray", "Wire", "Samples", "Normals",
                                           "Taxels", "Fields", "Export layout"}));
  EXPECT_TRUE(probe.contains("Contact")) << "the probe has a contact";
}

TEST(ExportButton, HasTheNumberOfProblems) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["taxels"][1]["center"] = layout["taxels"][0]["center"];  // two taxels at one place
  write_text(studio.folder() / "twice.taxels.json", layout.dump());
  studio.play({kIdle, kLayoutMode, kIdle, kIdle, dump("layout.json")}, {"twice.taxels.json"});
  const Json state = studio.state("layout.json");
  std::string label;
  for (const Json& widget : state["widgets"])
    if (widget["label"].get<std::string>().starts_with("Export layout")) label = widget["label"];
  EXPECT_TRUE(label.ends_with("warnings)") || label.ends_with("warning)") || label.ends_with("errors)")) << label;
  studio.play({kIdle, kLayoutMode, kIdle, kIdle, press(label), kIdle, kIdle, dump("asked.json")},
              {"twice.taxels.json"});
  EXPECT_TRUE(studio.state("asked.json")["file_dialog"]["open"]);
}

}  // namespace
}  // namespace taxel::test
