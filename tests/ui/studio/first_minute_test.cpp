// The first minute of somebody who has never seen the program: the demo's caption, the strip of tools, the examples.
#include <gtest/gtest.h>

#include <algorithm>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// The sweep of the window's start, over an edge.
const std::vector<std::string> kStartAtEdge{"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"};
const std::vector<std::string> kStartDemo{"--demo", kStartAtEdge[0], kStartAtEdge[1]};
const std::string kProbe = "Press X and touch the finger";

std::string wait_until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}

/// Returns a widget of a panel, or of any panel, or null.
Json widget(const Json& state, const std::string& label, const std::string& panel = "") {
  for (const Json& widget : state["widgets"])
    if (widget["label"] == label && (panel.empty() || widget["panel"] == panel)) return widget;
  return nullptr;
}

bool shows(const Json& state, const std::string& label) {
  return !widget(state, label).is_null();
}

double largest_reading(const Json& probe) {
  double largest = 0;
  for (const Json& value : probe["reading"]["values"]) largest = std::max(largest, value.get<double>());
  return largest;
}

TEST(FirstMinute, ReadsAProbeAfterOneKeyOfTheCaption) {
  const StudioProgram studio;
  studio.play({kIdle, wait_until(1), dump("demo.json"), R"({"do": "screenshot", "file": "demo.png"})", key("x"), kIdle,
               R"({"event": "mouse_move", "at": {"taxel": 3}})", kIdle, dump("read.json")},
              kStartDemo);
  const Json demo = studio.state("demo.json"), read = studio.state("read.json");
  EXPECT_TRUE(demo["simulation"]["history"]["demo"]["runs"]);
  EXPECT_TRUE(shows(demo, kProbe));
  EXPECT_FALSE(shows(read, kProbe));
  EXPECT_EQ(read["mode"], "layout");
  EXPECT_TRUE(read["probe"]["held"]);
  EXPECT_GT(largest_reading(read["probe"]), 1000) << read["probe"];
}

TEST(FirstMinute, ReadsAProbeAfterOneClick) {
  const StudioProgram studio;
  studio.play({kIdle, wait_until(1), press(kProbe), kIdle, R"({"event": "mouse_move", "at": {"taxel": 3}})", kIdle,
               dump("read.json")},
              kStartDemo);
  EXPECT_GT(largest_reading(studio.state("read.json")["probe"]), 1000);
}

TEST(FirstMinute, ShowsTheJumpingTaxelByOneClick) {
  const StudioProgram studio;
  studio.play({kIdle, wait_until(0.5), press("Show the jumping taxel"), kIdle,
               R"({"do": "wait_for", "pointer": "/explain/verdict/cause", "contains": "sampling_noise"})", kIdle,
               dump("jumped.json")},
              kStartDemo);
  const Json jumped = studio.state("jumped.json");
  EXPECT_FALSE(jumped["plot"]["close_up"].is_null());
  EXPECT_FALSE(jumped["simulation"]["playing"]);
  EXPECT_FALSE(shows(jumped, kProbe)) << "the caption was that of the demo";
}

TEST(FirstMinute, ClosesTheCaptionForGood) {
  const StudioProgram studio;
  studio.play({kIdle, wait_until(0.5), press("Close"), kIdle, dump("closed.json"), wait_until(0.7), dump("later.json")},
              kStartDemo);
  EXPECT_FALSE(shows(studio.state("closed.json"), kProbe));
  EXPECT_FALSE(shows(studio.state("later.json"), kProbe));
}

TEST(FirstMinute, SweepsADroppedMeshWithAKnownPatternInFiveActions) {
  const StudioProgram studio;
  // Dropped; then: 1 Generate, 2 a pattern, 3 Add taxels, 4 SIMULATE, which runs.
  studio.play({kIdle, R"({"event": "drop", "files": [")" + kMeshFile + R"("]})", kIdle, press("Generate"), kIdle,
               press("Spread"), kIdle, kIdle, press("Add taxels"), kIdle, kIdle, press("SIMULATE"), kIdle,
               wait_until(0.3), dump("runs.json")},
              {"--empty", kStartAtEdge[0], kStartAtEdge[1]});
  const Json runs = studio.state("runs.json");
  EXPECT_EQ(runs["mode"], "simulate");
  EXPECT_TRUE(runs["simulation"]["playing"]);
  EXPECT_GT(runs["document"]["layout"]["taxels"].size(), 3U);
}

TEST(ToolStrip, HasTheToolsOfEachModeAndPressesThem) {
  const StudioProgram studio;
  studio.play(
      {kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json"), press("Place"), kIdle, dump("place.json"),
       press("Select"), kIdle, dump("select.json"), press("Probe"), kIdle, dump("probe.json")},
      {kLayoutFile});
  const Json simulate = studio.state("simulate.json"), layout = studio.state("layout.json");
  for (const char* tool : {"Select", "Place", "Paint", "Probe", "Measure", "Generate"}) {
    EXPECT_FALSE(widget(layout, tool, "Tools").is_null()) << tool;
  }
  for (const char* tool : {"Probe", "Explain", "Record", "Video"})
    EXPECT_FALSE(widget(simulate, tool, "Tools").is_null()) << tool;
  EXPECT_FALSE(shows(simulate, "Place"));
  EXPECT_EQ(studio.state("place.json")["tool"]["name"], "place");
  EXPECT_EQ(studio.state("select.json")["tool"]["name"], "none");
  EXPECT_TRUE(studio.state("probe.json")["probe"].is_object());
}

TEST(StartCard, OpensAnExampleByItsPicture) {
  const StudioProgram studio;
  studio.play({kIdle, dump("start.json"), R"({"do": "screenshot", "file": "start.png"})", press("Hand grasps a ball"),
               kIdle, wait_until(0.3), key("Space"), kIdle, dump("hand.json")},
              {"--empty", "--state-dir", "state"});
  const Json start = studio.state("start.json"), hand = studio.state("hand.json");
  for (const char* label : {"Fingertip sweep", "The jumping taxel", "Hand grasps a ball", "BioTac, 19 electrodes"}) {
    const Json rect = widget(start, label)["rect"];
    ASSERT_TRUE(rect.is_array()) << label;
    EXPECT_GT(rect[2].get<double>() - rect[0].get<double>(), 100) << label;
  }
  EXPECT_EQ(hand["simulation"]["sensors"].size(), 5U);
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "state/examples/scenes/hand_grasps_ball.xml"));
}

TEST(StartCard, FitsIntoASmallWindowWithRecentFiles) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json",
             R"({"recent": ["a.obj", "b.obj", "c.obj", "d.obj", "e.obj", "f.obj", "g.obj"]})");
  studio.play({kIdle, dump("start.json"), R"({"do": "screenshot", "file": "start.png"})"},
              {"--empty", "--size", "800x600", "--state-dir", "state"});
  const Json start = studio.state("start.json");
  for (const char* label : {"Open", "Fingertip sweep", "BioTac, 19 electrodes", "e.obj"}) {
    const Json rect = widget(start, label)["rect"];
    ASSERT_TRUE(rect.is_array()) << label;
    EXPECT_GE(rect[0].get<double>(), 0) << label;
    EXPECT_GE(rect[1].get<double>(), 0) << label;
    EXPECT_LE(rect[2].get<double>(), 800) << label;
    EXPECT_LE(rect[3].get<double>(), 600) << label;
  }
}

TEST(ExampleMenu, OpensAKnownSensorWithItsSource) {
  const StudioProgram studio;
  studio.play({kIdle, press("Help"), kIdle, press("Examples"), kIdle, press("iCub fingertip, 12 taxels"), kIdle,
               dump("icub.json")},
              {"--empty"});
  const Json icub = studio.state("icub.json");
  EXPECT_EQ(icub["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_NE(icub["messages"].dump().find("Our own estimate"), std::string::npos) << icub["messages"];
}

TEST(ExampleMenu, SaysWhichFileOfASceneCannotBeWritten) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/examples", "a file where a folder has to be");
  studio.play({kIdle, dump("before.json"), press("Help"), kIdle, press("Examples"), kIdle, press("Hand grasps a ball"),
               kIdle, dump("after.json")},
              {"--state-dir", "state", kLayoutFile});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_EQ(after["document"], before["document"]);
  EXPECT_NE(after["messages"].dump().find("state/examples"), std::string::npos) << after["messages"];
}

}  // namespace
}  // namespace taxel::test
