// Mouse and keys: the effects of each event, and that nothing else changes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "studio_program.h"

namespace taxel::test {
namespace {

std::string idle() {
  return R"({"do": "wait_idle"})";
}
std::string dump(const std::string& file) {
  return R"({"do": "dump_state", "file": ")" + file + R"("})";
}
std::string key(const std::string& name) {
  return R"({"event": "key", "key": ")" + name + R"("})";
}
std::string click(const std::string& at) {
  return R"({"event": "click", "at": )" + at + "}";
}
std::string widget(const std::string& label) {
  return R"({"widget": ")" + label + R"("})";
}

const std::string kLayout = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";

/// Returns the part of a state that a gesture in the view must not change.
Json untouched(Json state) {
  // `sensor_boxes` are in pixels of the view, and the texts of `amount` have the labels of the view among them.
  for (const char* part : {"camera", "clicks", "taxels", "samples", "polygons", "labels", "pace", "profile",
                           "sensor_boxes", "contact", "covered", "amount"})
    state.erase(part);
  // The legend of the marks folds where it would cover the sensor.
  Json widgets = Json::array();
  for (const Json& widget : state["widgets"])
    if (widget["panel"] != "Marks") widgets.push_back(widget);
  state["widgets"] = widgets;
  return state;
}

TEST(Camera, ChangesNothingElseInAScriptedOrbit) {
  const StudioProgram studio;
  studio.play({key("="), key("="), R"({"do": "wait_time", "time": 1.1})", key("Space"), idle(),
               R"({"event": "mouse_move", "at": {"view": [0.326, 0.681]}})", idle(), dump("before.json"),
               R"({"event": "mouse_down", "at": {"view": [0.326, 0.681]}})", idle(),
               R"({"event": "mouse_move", "at": {"view": [0.442, 0.796]}})", idle(), R"({"event": "mouse_up"})",
               R"({"event": "mouse_move", "at": {"view": [0.326, 0.681]}})", idle(), dump("after.json")});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_NE(before["camera"]["azimuth_deg"], after["camera"]["azimuth_deg"]);
  EXPECT_NE(before["camera"]["elevation_deg"], after["camera"]["elevation_deg"]);
  EXPECT_EQ(before["camera"]["target"], after["camera"]["target"]);
  EXPECT_EQ(before["camera"]["distance"], after["camera"]["distance"]);
  EXPECT_EQ(untouched(before), untouched(after));
}

TEST(Camera, ZoomsByTheWheelAndPansByRightDrag) {
  const StudioProgram studio;
  studio.play({R"({"frame": 5, "event": "mouse_move", "at": {"view": [0.326, 0.681]}})", idle(), dump("before.json"),
               R"({"event": "wheel", "at": {"view": [0.326, 0.681]}, "y": 2})", idle(), dump("zoomed.json"),
               R"({"event": "mouse_down", "button": "right", "at": {"view": [0.326, 0.681]}})", idle(),
               R"({"event": "mouse_move", "at": {"view": [0.413, 0.767]}})", idle(),
               R"({"event": "mouse_up", "button": "right"})", idle(), dump("panned.json"), key("Home"), idle(),
               dump("framed.json")},
              {kLayout});
  const Json before = studio.state("before.json")["camera"], zoomed = studio.state("zoomed.json")["camera"];
  const Json panned = studio.state("panned.json")["camera"], framed = studio.state("framed.json")["camera"];
  EXPECT_LT(zoomed["distance"], before["distance"]);
  EXPECT_NE(zoomed["target"], before["target"]) << "the wheel zooms at the pointer";
  EXPECT_NE(panned["target"], zoomed["target"]);
  EXPECT_EQ(panned["distance"], zoomed["distance"]);
  EXPECT_NE(framed["target"], panned["target"]);
  EXPECT_GT(framed["distance"], zoomed["distance"]);
}

TEST(Camera, ZoomsAtTheTaxelUnderThePointer) {
  const StudioProgram studio;
  studio.play(
      {R"({"event": "key", "key": "1", "mods": ["ctrl"]})", idle(), R"({"event": "mouse_move", "at": {"taxel": 3}})",
       idle(), dump("before.json"), R"({"event": "wheel", "at": {"taxel": 3}, "y": 4})", idle(), dump("after.json")},
      {kLayout});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_LT(after["camera"]["distance"].get<double>(), 0.7 * before["camera"]["distance"].get<double>());
  for (const std::size_t axis : {0U, 1U})
    EXPECT_NEAR(after["taxels"][3]["pixel"][axis].get<double>(), before["taxels"][3]["pixel"][axis].get<double>(), 2)
        << "the taxel stays below the pointer";
}

TEST(Camera, LooksAtTheMeshByRightDoubleClick) {
  const StudioProgram studio;
  studio.play({R"({"event": "key", "key": "1", "mods": ["ctrl"]})", idle(),
               R"({"event": "double_click", "button": "right", "at": {"view": [0.471, 0.767]}})", idle(),
               dump("state.json")});
  const Json camera = studio.state("state.json")["camera"];
  const LoadedMesh mesh = load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj");
  const dvec3 target(camera["target"][0], camera["target"][1], camera["target"][2]);
  EXPECT_LT(MeshIndex(mesh.mesh).closest_point(target).distance, 1e-6);
  EXPECT_NE(target, mesh.mesh->bounds().center()) << "it was framed before";
}

TEST(Clicks, AreCountedTwiceAndAsADoubleClickWithinOneFrame) {
  const StudioProgram studio;
  studio.play({R"({"frame": 4, "event": "click", "at": {"view": [0.326, 0.681]}})",
               R"({"frame": 4, "event": "click", "at": {"view": [0.326, 0.681]}})", idle(), dump("twice.json"),
               R"({"frame": 30, "event": "click", "at": {"view": [0.326, 0.681]}})", idle(), dump("thrice.json")});
  EXPECT_EQ(studio.state("twice.json")["clicks"]["left"], 2);
  EXPECT_EQ(studio.state("twice.json")["clicks"]["left_double"], 1);
  EXPECT_EQ(studio.state("thrice.json")["clicks"]["left"], 3);
  EXPECT_EQ(studio.state("thrice.json")["clicks"]["left_double"], 1) << "a later click is one of its own";
}

TEST(Clicks, ToggleTwiceWithinOneFrame) {
  const StudioProgram studio;
  const std::string wire = click(widget("Toolbar/Wire"));
  studio.play(
      {wire, idle(), dump("once.json"), wire, wire, idle(), dump("thrice.json"), wire, idle(), dump("four.json")});
  EXPECT_TRUE(studio.state("once.json")["overlays"]["wireframe"]);
  EXPECT_TRUE(studio.state("thrice.json")["overlays"]["wireframe"]);
  EXPECT_FALSE(studio.state("four.json")["overlays"]["wireframe"]);
}

TEST(Selection, WorksByViewTableAndBarAndEndsByEscape) {
  const StudioProgram studio;
  studio.play({R"({"event": "key", "key": "1", "mods": ["ctrl"]})", idle(), click(R"({"taxel": 3})"), idle(),
               dump("view.json"), R"({"event": "key", "key": "2", "mods": ["ctrl"]})", idle(), click(widget("Taxel 5")),
               idle(), dump("table.json"), key("Esc"), idle(), dump("cleared.json")});
  EXPECT_EQ(studio.state("view.json")["selection"]["taxel"], 3);
  EXPECT_EQ(studio.state("table.json")["selection"]["taxel"], 5);
  EXPECT_TRUE(studio.state("cleared.json")["selection"]["taxel"].is_null());
}

TEST(Selection, TogglesByShiftAndSelectsAllNoneAndOthersByKeys) {
  const StudioProgram studio;
  const std::string shift = R"(, "mods": ["shift"]})";
  studio.play({R"({"event": "key", "key": "1", "mods": ["ctrl"]})",
               idle(),
               click(R"({"taxel": 3})"),
               idle(),
               R"({"event": "click", "at": {"taxel": 0})" + shift,
               idle(),
               R"({"event": "click", "at": {"widget": "Taxel 7"})" + shift,
               idle(),
               dump("three.json"),
               R"({"event": "click", "at": {"taxel": 0})" + shift,
               idle(),
               dump("two.json"),
               R"({"event": "key", "key": "i", "mods": ["ctrl"]})",
               idle(),
               dump("others.json"),
               key("a"),
               idle(),
               dump("all.json"),
               R"({"event": "key", "key": "a", "mods": ["alt"]})",
               idle(),
               dump("none.json")});
  const auto taxels = [&](const char* file) { return studio.state(file)["selection"]["taxels"]; };
  EXPECT_EQ(taxels("three.json"), Json({3, 0, 7}));
  EXPECT_EQ(studio.state("three.json")["selection"]["taxel"], 7) << "the last one is the active one";
  EXPECT_EQ(taxels("two.json"), Json({3, 7}));
  EXPECT_EQ(taxels("others.json"), Json({0, 1, 2, 4, 5, 6, 8, 9, 10, 11}));
  EXPECT_EQ(taxels("all.json").size(), 12U);
  EXPECT_EQ(taxels("none.json"), Json::array());
}

TEST(Selection, KeepsItsTaxelsFromLayoutToSimulation) {
  const StudioProgram studio;
  studio.play({R"({"event": "key", "key": "1", "mods": ["ctrl"]})", idle(), click(R"({"taxel": 3})"), idle(),
               R"({"event": "key", "key": "2", "mods": ["ctrl"]})", idle(), dump("simulate.json")});
  EXPECT_EQ(studio.state("simulate.json")["selection"]["taxels"], Json({3}));
}

TEST(Transport, PlaysStepsResetsAndChangesSpeedByKeys) {
  const StudioProgram studio;
  studio.play({R"({"frame": 10, "event": "key", "key": "Space"})", idle(), dump("paused.json"), key("Right"),
               key("Right"), idle(), dump("stepped.json"), key("-"), idle(), key("Space"),
               R"({"do": "wait_time", "time": 0.5})", dump("slow.json"), key("Backspace"), idle(), dump("reset.json")});
  const Json paused = studio.state("paused.json")["simulation"], stepped = studio.state("stepped.json")["simulation"];
  EXPECT_FALSE(paused["playing"]);
  const auto says = [&](const char* file, const char* text) {
    return studio.state(file)["widgets"].dump().find(text) != std::string::npos;
  };
  EXPECT_TRUE(says("paused.json", "simulation paused"));
  EXPECT_FALSE(says("slow.json", "simulation paused"));
  EXPECT_EQ(stepped["step"], paused["step"].get<int>() + 2);
  EXPECT_EQ(studio.state("slow.json")["simulation"]["speed"], 0.5);
  EXPECT_TRUE(studio.state("slow.json")["simulation"]["playing"]);
  EXPECT_LT(studio.state("reset.json")["simulation"]["time"], 0.2);
}

TEST(Transport, RestartsTheRunAfterItsEnd) {
  const StudioProgram studio;
  studio.play({R"({"do": "wait_idle"})", key("="), key("="), key("="), key("="), idle(),
               R"({"frame": 20, "do": "dump_state", "file": "end.json"})", click(widget("Run")), idle(),
               dump("again.json")});
  const Json end = studio.state("end.json")["simulation"], again = studio.state("again.json")["simulation"];
  EXPECT_TRUE(end["finished"]);
  EXPECT_FALSE(end["playing"]);
  EXPECT_NE(studio.state("end.json")["widgets"].dump().find("simulation ended"), std::string::npos);
  EXPECT_TRUE(again["playing"]);
  EXPECT_LT(again["time"], end["time"]);
  EXPECT_LT(again["rows"], end["rows"]);
}

TEST(Keys, GoToATextFieldFirst) {
  const StudioProgram studio;
  studio.play({R"({"event": "key", "key": "o", "mods": ["ctrl"]})", idle(), dump("before.json"), key("w"),
               R"({"event": "text", "text": "w"})", idle(), dump("after.json")});
  EXPECT_EQ(studio.state("before.json")["overlays"], studio.state("after.json")["overlays"]);
}

TEST(Keys, PlayBySpaceAfterAButtonWasClicked) {
  const StudioProgram studio;
  studio.play({R"({"frame": 5, "event": "click", "at": {"widget": "Toolbar/Wire"}})", idle(), key("Space"), idle(),
               dump("state.json")});
  EXPECT_TRUE(studio.state("state.json")["overlays"]["wireframe"]) << "not switched back by Space";
  EXPECT_FALSE(studio.state("state.json")["simulation"]["playing"]);
}

TEST(Sweep, RunsAgainWithTheParametersOfTheInspector) {
  const StudioProgram studio;
  studio.play({idle(), R"j({"event": "double_click", "at": {"widget": "Inspector/Tilt (°)"}})j", idle(),
               R"({"event": "text", "text": "30"})", key("Enter"), idle(), dump("before.json"),
               click(widget("Run scenario")), idle(), dump("after.json")},
              {"--size", "1280x2400"});
  EXPECT_NE(studio.state("before.json")["simulation"]["sensors"][0]["quaternion"],
            studio.state("after.json")["simulation"]["sensors"][0]["quaternion"]);
  EXPECT_LT(studio.state("after.json")["simulation"]["time"], studio.state("before.json")["simulation"]["time"]);
}

}  // namespace
}  // namespace taxel::test
