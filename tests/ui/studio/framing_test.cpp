// What the cameras show when a scene first exists and after a change of mode, and what a start without taxels says.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kSimulateMode = key("2", kCtrl);
const std::string kPlaceOne = click(R"({"world": [0, -0.0075, 0.015]})", kCtrl);

TEST(Framing, ShowsTheSensorWhenItsSceneFirstExists) {
  const StudioProgram studio;
  studio.play(
      {kIdle, kPlaceOne, kIdle, kSimulateMode, kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json")},
      {kMeshFile});
  for (const char* file : {"simulate.json", "layout.json"}) {
    const Json state = studio.state(file);
    ASSERT_EQ(state["sensor_boxes"].size(), 1U) << file;
    EXPECT_TRUE(state["sensor_boxes"][0]["inside"]) << file << state["sensor_boxes"][0]["corners"];
  }
  EXPECT_EQ(studio.state("simulate.json")["mode"], "simulate");
}

Lines drag_away() {
  return {R"({"event": "mouse_down", "button": "right", "at": [300, 300]})",
          kIdle,
          R"({"event": "mouse_move", "at": [900, 300]})",
          kIdle,
          R"({"event": "mouse_up", "button": "right"})",
          kIdle};
}

TEST(Framing, ShowsASensorOutsideTheViewAtAChangeOfMode) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, key("Space"), kIdle},
                      drag_away(),
                      drag_away(),
                      {dump("away.json"), kLayoutMode, kIdle, kSimulateMode, kIdle, dump("back.json"),
                       R"({"event": "wheel", "at": [640, 300], "y": 6})", kIdle, dump("near.json"), kLayoutMode, kIdle,
                       kSimulateMode, kIdle, dump("kept.json")}}),
              {kLayoutFile});
  EXPECT_TRUE(studio.state("away.json")["sensor_boxes"][0]["outside"]);
  EXPECT_TRUE(studio.state("back.json")["sensor_boxes"][0]["inside"]);
  EXPECT_EQ(studio.state("kept.json")["camera"], studio.state("near.json")["camera"]) << "a sensor in view is left so";
}

TEST(Simulate, SaysThatTaxelsAreMissing) {
  for (const std::string& start : {kSimulateMode, key("Space")}) {
    const StudioProgram studio;
    studio.play({kIdle, start, kIdle, dump("asked.json")}, {kMeshFile});
    const Json state = studio.state("asked.json");
    EXPECT_EQ(state["mode"], "layout");
    EXPECT_NE(state["messages"].dump().find("the layout has no taxels"), std::string::npos) << start;
  }
}

}  // namespace
}  // namespace taxel::test
