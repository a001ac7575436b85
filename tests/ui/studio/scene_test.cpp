// A MuJoCo scene in the window: dragged bodies, controls, and layouts on geoms, all with mouse and keys.
#include <gtest/gtest.h>

#include <cmath>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string mouse(const std::string& event, const Json& at, const std::string& button, const Json& mods) {
  Json line{{"event", event}, {"at", at}};
  if (event != "mouse_move") {
    line["button"] = button;
    line["mods"] = mods;
  }
  return line.dump();
}
std::string world(double x, double y, double z) {
  return Json{{"world", {x, y, z}}}.dump();
}
std::string double_click(const std::string& at) {
  return R"({"event": "double_click", "button": "left", "at": )" + at + "}";
}

constexpr const char* kScene = R"(<mujoco><option gravity='0 0 0'/><worldbody>
  <body name='ball' pos='0 0 .1'><freejoint/><geom name='ball' type='sphere' size='.05' mass='1'/></body>
  <body name='arm' pos='.2 0 0'><joint name='elbow' axis='0 1 0' range='-90 45' damping='1'/>
    <geom type='capsule' fromto='0 0 0 0 0 .2' size='.02' mass='.1'/></body>
  <body name='lead' mocap='true' pos='-.2 0 0'><geom name='lead' type='box' size='.01 .01 .01'/></body>
  <body name='led' pos='-.2 0 0'><freejoint/><geom name='led' type='box' size='.02 .02 .02'/></body></worldbody>
  <equality><weld name='hold' body1='lead' body2='led'/></equality>
  <actuator><motor name='turn' joint='elbow' ctrlrange='0 2'/></actuator>
  <keyframe><key name='bent' qpos='0 0 .1 1 0 0 0 .5 -.2 0 0 1 0 0 0' ctrl='.25'/></keyframe></mujoco>)";

Json geom_of(const Json& state, const std::string& name) {
  for (const Json& geom : state["scene"]["geoms"])
    if (geom["name"] == name) return geom;
  return nullptr;
}
double pressed_x(const Json& state, const char* name, int axis) {
  return geom_of(state, name)["position"][static_cast<std::size_t>(axis)];
}

TEST(Scene, SelectsTurnsAndPullsBodiesLikeMujocosViewer) {
  const StudioProgram studio;
  write_text(studio.folder() / "scene.xml", kScene);
  const auto drag = [](const char* button, double dx, double dy) {
    const Json ctrl = {"ctrl"};
    return Lines{mouse("mouse_down", {600, 300}, button, ctrl), mouse("mouse_move", {600 + dx, 300 + dy}, button, ctrl),
                 kIdle};
  };
  const auto release = [](const char* button) { return Lines{mouse("mouse_up", {640, 300}, button, {"ctrl"}), kIdle}; };
  studio.play(joined({{kIdle, key("Space"), kIdle, dump("open.json"), double_click(world(0, 0, 0.1)), kIdle, kIdle,
                       dump("selected.json"), R"({"do": "screenshot", "file": "selected.png"})"},
                      drag("right", 40, 0),  // paused: the body follows the mouse
                      {dump("pulled.json"), R"({"do": "screenshot", "file": "pulled.png"})"},
                      release("right"),
                      drag("left", 0, 120),
                      {dump("turned.json")},
                      release("left"),
                      {key("Space"), kIdle},
                      drag("right", -60, 0),  // running: the body is pulled by a spring
                      {kIdle, kIdle, kIdle, kIdle, dump("drawn.json"), R"({"do": "screenshot", "file": "drawn.png"})"},
                      release("right"),
                      {dump("let_go.json"), key("Backspace"), kIdle, dump("reset.json"), key("Escape"), kIdle,
                       dump("escaped.json")}}),
              {"scene.xml"});
  const Json open = studio.state("open.json"), selected = studio.state("selected.json");
  EXPECT_EQ(open["scene"]["body"], nullptr);
  EXPECT_EQ(selected["scene"]["body"], "ball");
  EXPECT_NE(studio.picture("selected.png").rgb, studio.picture("pulled.png").rgb);
  const Json pulled = studio.state("pulled.json"), turned = studio.state("turned.json");
  for (const Json& state : {pulled, turned}) EXPECT_EQ(state["camera"], open["camera"]);
  EXPECT_FALSE(pulled["scene"]["hand"]["turns"]);
  EXPECT_GT(std::hypot(pressed_x(pulled, "ball", 0), pressed_x(pulled, "ball", 1)), 0.005);
  EXPECT_NEAR(pressed_x(pulled, "ball", 2), 0.1, 1e-12);  // sideways
  EXPECT_TRUE(turned["scene"]["hand"]["turns"]);
  // 120 pixels are 120 / height of a full turn.
  const double angle = 2 * std::acos(std::abs(geom_of(turned, "ball")["quaternion"][0].get<double>()));
  EXPECT_NEAR(angle, 2 * kPi * 120 / open["view"]["height"].get<double>(), 1e-9);
  const Json drawn = studio.state("drawn.json"), let_go = studio.state("let_go.json");
  EXPECT_FALSE(drawn["scene"]["hand"].is_null());
  EXPECT_GT(drawn["simulation"]["step"].get<int>(), turned["simulation"]["step"].get<int>());
  EXPECT_NE(pressed_x(drawn, "ball", 0), pressed_x(turned, "ball", 0));
  EXPECT_TRUE(let_go["scene"]["hand"].is_null());
  EXPECT_EQ(studio.state("reset.json")["simulation"]["step"], 0);
  EXPECT_EQ(geom_of(studio.state("reset.json"), "ball")["position"], geom_of(open, "ball")["position"]);
  EXPECT_EQ(studio.state("escaped.json")["scene"]["body"], nullptr);
}

TEST(Scene, TogglesGroupsOfGeomsLikeMujocosViewer) {
  const StudioProgram studio;
  write_text(studio.folder() / "scene.xml", R"(<mujoco><option gravity='0 0 0'/><worldbody>
  <body name='ball' pos='0 0 .1'><freejoint/><geom name='ball' type='sphere' size='.05' group='2' contype='0'/></body>
  <body name='shell' pos='0 0 .1'><freejoint/><geom name='shell' type='box' size='.06 .06 .06' group='3' contype='0'
    conaffinity='0'/></body></worldbody></mujoco>)");
  double z = 0.1;
  const auto look =
      [&](const std::string& name) {  // a different place each time, because four clicks on one place are double-clicks
        z = z == 0.1 ? 0.12 : 0.1;
        return Lines{R"({"event": "mouse_move", "at": [5, 5]})",
                     kIdle,
                     R"({"do": "screenshot", "file": ")" + name + R"(.png"})",
                     double_click(world(0, 0, z)),
                     kIdle,
                     kIdle,
                     dump(name + ".json"),
                     key("Escape"),
                     kIdle};
      };
  studio.play(joined({{kIdle, key("Space"), kIdle},
                      look("first"),
                      {key("3"), kIdle},
                      look("both"),
                      {key("3"), kIdle, key("2"), kIdle},
                      look("none"),
                      {key("2"), kIdle},
                      look("again")}),
              {"scene.xml"});
  EXPECT_EQ(studio.state("first.json")["scene"]["body"], "ball") << "of the groups 0 to 2";
  EXPECT_EQ(studio.state("both.json")["scene"]["body"], "shell");
  EXPECT_EQ(studio.state("none.json")["scene"]["body"], nullptr);
  EXPECT_EQ(studio.state("first.json")["scene"]["geoms"].size(), 2U) << "hidden ones are there, too";
  const auto middle = [&](const std::string& name) {  // of the view, where the ball is
    const Picture picture = studio.picture(name);
    const Json rect = studio.state("first.json")["view"]["rect"];
    const auto at = [&](int a, int b) {
      return static_cast<int>(0.5 * (rect[a].get<double>() + rect[b].get<double>()));
    };
    const auto first = picture.rgb.begin() + 3 * (at(1, 3) * picture.width + at(0, 2));
    return std::vector<int>(first, first + 3);
  };
  EXPECT_EQ(middle("first.png"), middle("again.png"));
  EXPECT_NE(middle("first.png"), middle("both.png")) << "the shell is in front of it";
  EXPECT_NE(middle("first.png"), middle("none.png"));
  EXPECT_EQ(studio.state("again.json")["scene"]["body"], "ball");
}

/// Returns the place of a widget: left, top, right and bottom [pixels].
Json rect_of(const Json& state, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["label"] == label) return widget["rect"];
  ADD_FAILURE() << "no widget " << label;
  return {0, 0, 0, 0};
}

TEST(Scene, SetsControlsExceptInRecordedSteps) {
  const StudioProgram studio;
  write_text(studio.folder() / "scene.xml", kScene);
  std::vector<std::string> arguments = tall_window(studio, "scene.xml");
  studio.play({kIdle,
               key("Space"),
               kIdle,
               dump("open.json"),
               press("Actuator turn"),
               kIdle,
               press("Joint elbow"),
               kIdle,
               dump("set.json"),
               press("hold"),
               kIdle,
               key("Right"),
               kIdle,
               key("Right"),
               kIdle,
               dump("stepped.json"),
               key("Left"),
               kIdle,
               press("Actuator turn"),
               kIdle,
               dump("past.json"),
               key("End"),
               kIdle,
               press("bent"),
               kIdle,
               dump("bent.json"),
               R"({"do": "screenshot", "file": "controls.png"})"},
              arguments);
  const Json open = studio.state("open.json")["scene"], set = studio.state("set.json")["scene"];
  const Json slider = rect_of(studio.state("open.json"), "Joint elbow"),
             value = rect_of(studio.state("open.json"), "Value of Joint elbow");
  EXPECT_GE(value[0].get<double>(), slider[2].get<double>()) << "next to the slider, not under its knob";
  EXPECT_NEAR(value[1].get<double>() + value[3].get<double>(), slider[1].get<double>() + slider[3].get<double>(), 8);
  EXPECT_EQ(open["actuators"][0]["value"], 0);
  EXPECT_NEAR(set["actuators"][0]["value"].get<double>(), 1, 0.05);  // the middle of the range
  EXPECT_NEAR(set["joints"][0]["value"].get<double>(), -22.5 * kPi / 180, 0.05);
  EXPECT_EQ(set["held"].size(), 1U);
  const Json stepped = studio.state("stepped.json");
  EXPECT_EQ(stepped["scene"]["equalities"][0]["value"], 0);
  EXPECT_TRUE(stepped["scene"]["held"].empty());
  EXPECT_GT(stepped["scene"]["joints"][0]["value"], set["joints"][0]["value"]);  // the motor turns the joint
  const Json past = studio.state("past.json");
  EXPECT_TRUE(past["simulation"]["history"]["recorded"]);
  EXPECT_EQ(past["scene"]["actuators"], stepped["scene"]["actuators"]);
  EXPECT_EQ(past["simulation"]["history"]["last"], stepped["simulation"]["history"]["last"]);
  const Json bent = studio.state("bent.json");
  EXPECT_EQ(bent["scene"]["joints"][0]["value"], 0.5);
  EXPECT_EQ(bent["scene"]["actuators"][0]["value"], 0.25);
  EXPECT_EQ(bent["simulation"]["step"], 0);
}

TEST(Scene, DrawsWeldsInRecordedSteps) {
  const StudioProgram studio;
  write_text(studio.folder() / "scene.xml", kScene);
  const auto picture = [](const std::string& name) { return R"({"do": "screenshot", "file": ")" + name + R"("})"; };
  studio.play({kIdle,
               key("Space"),
               kIdle,
               press("Controls/Mocap lead Z"),
               kIdle,
               key("a", kCtrl),
               type("20"),
               key("Enter"),
               kIdle,  // the welded body follows the dragged one
               key("Right"),
               kIdle,
               key("Right"),
               kIdle,
               dump("second.json"),
               picture("second.png"),
               key("Right"),
               kIdle,
               press("hold"),
               kIdle,
               key("Right"),
               kIdle,
               dump("loose.json"),
               key("Left"),
               kIdle,
               key("Left"),
               kIdle,
               dump("back.json"),
               picture("back.png"),
               key("End"),
               kIdle,
               dump("end.json")},
              tall_window(studio, "scene.xml"));
  const Json second = studio.state("second.json"), back = studio.state("back.json");
  ASSERT_EQ(second["scene"]["held"].size(), 1U);
  const Json held = second["scene"]["held"][0];
  EXPECT_GT(glm::distance(vector_of(held["a"]), vector_of(held["b"])), 1e-4) << "they are apart";
  ASSERT_EQ(back["simulation"]["step"], second["simulation"]["step"]);
  EXPECT_TRUE(back["simulation"]["history"]["recorded"]);
  EXPECT_EQ(back["scene"]["held"], second["scene"]["held"]);
  EXPECT_TRUE(studio.state("loose.json")["scene"]["held"].empty()) << "it was let go";
  EXPECT_TRUE(studio.state("end.json")["scene"]["held"].empty());
}

/// A finger without a sensor, pressed into the floor.
constexpr const char* kFinger = R"(<mujoco><asset><mesh name='tip' file='fingertip.obj'/></asset><worldbody>
  <geom name='floor' type='plane' size='.2 .2 .1'/>
  <body pos='0 0 .0061' quat='.70710678 .70710678 0 0'><freejoint/><geom name='tip' type='mesh' mesh='tip'/></body>
  <body pos='.05 0 .0061' quat='.70710678 .70710678 0 0'><freejoint/><geom type='mesh' mesh='tip'/></body></worldbody></mujoco>)";

/// Writes the scene, a mesh and a coarse layout.
void write_finger(const std::filesystem::path& folder) {
  std::filesystem::copy_file(kMeshFile, folder / "fingertip.obj");
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", "fingertip.obj"}, {"scale", {1, 1, 1}}};
  layout["sampling"]["density"] = 1e6;
  write_text(folder / "tip.taxels.json", layout.dump());
  write_text(folder / "scene.xml", kFinger);
}
Lines type_path(const std::string& path) {
  return {kIdle, type(path), kIdle, key("Enter"), kIdle, kIdle};
}

TEST(Scene, AttachesDetachesAndSavesLayoutsOfGeoms) {
  const StudioProgram studio;
  write_finger(studio.folder());
  const std::string folder = studio.folder().string();
  studio.play(joined({{kIdle, key("Space"), kIdle, press("tip"), kIdle, press("body 2, tip"), kIdle,
                       dump("chosen.json"), press("Attach a layout to 2 geoms...")},
                      type_path(folder + "/tip.taxels.json"),
                      {dump("attached.json"), R"({"do": "screenshot", "file": "attached.png"})", press("Detach body_2"),
                       kIdle, kIdle, dump("detached.json"), press("Save scene as...")},
                      type_path(folder + "/saved/mine"),
                      {dump("saved.json")}}),
              tall_window(studio, "scene.xml"));
  EXPECT_EQ(studio.state("chosen.json")["scene"]["chosen"], Json({"tip", "body_2"}));
  EXPECT_TRUE(studio.state("chosen.json")["simulation"]["sensors"].empty());
  const Json attached = studio.state("attached.json"), detached = studio.state("detached.json");
  ASSERT_EQ(attached["simulation"]["sensors"].size(), 2U) << attached["messages"].dump(1);
  for (const Json& sensor : attached["simulation"]["sensors"]) EXPECT_GT(sensor["max_pressure"], 1000);
  EXPECT_EQ(attached["scene"]["attached"].size(), 2U);
  EXPECT_EQ(attached["simulation"]["playing"], false);  // unchanged
  ASSERT_EQ(detached["simulation"]["sensors"].size(), 1U);
  EXPECT_EQ(detached["camera"], attached["camera"]);
  EXPECT_EQ(file_text(studio.folder() / "scene.xml"), kFinger);  // the file is unchanged
  EXPECT_NE(studio.state("saved.json")["messages"].dump().find("Saved " + folder + "/saved/mine.xml"),
            std::string::npos);
  ASSERT_TRUE(std::filesystem::exists(studio.folder() / "saved/mine.xml"));
  // The saved scene opens with its sensor and gives the same readings.
  studio.play({kIdle, key("Backspace"), kIdle, dump("again.json")}, {"saved/mine.xml"});
  const Json again = studio.state("again.json")["simulation"]["sensors"];
  ASSERT_EQ(again.size(), 1U);
  const double before = detached["simulation"]["sensors"][0]["max_pressure"];
  EXPECT_NEAR(again[0]["max_pressure"].get<double>(), before, 1e-3 * before);
}

/// The body under the pointer is also found through its geom's sensor.
TEST(Scene, LiftsTheBallOfTheExample) {
  const StudioProgram studio;
  studio.play({kIdle, R"({"do": "wait_time", "time": 1.2})", key("Space"), kIdle, dump("held.json"),
               R"({"do": "screenshot", "file": "held.png"})"},
              {TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml"});
  const Json held = studio.state("held.json");
  ASSERT_EQ(held["simulation"]["sensors"].size(), 5U);
  for (const Json& sensor : held["simulation"]["sensors"]) EXPECT_GT(sensor["polygons"], 20);
  EXPECT_GT(pressed_x(held, "ball", 2), 0.111 + 0.025) << "above its stand";
  EXPECT_EQ(held["scene"]["joints"].size(), 23U);
}

TEST(Scene, ReportsASceneThatCannotBeOpened) {
  const StudioProgram studio;
  write_text(studio.folder() / "no_plugin.xml",
             "<mujoco><extension><plugin plugin='mujoco.sdf.torus'><instance name='t'/></plugin></extension>"
             "<worldbody><geom size='1'/></worldbody></mujoco>");
  const Outcome outcome = studio.run({kIdle, kIdle}, {"no_plugin.xml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("plugin mujoco.sdf.torus not found"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--plugins FOLDER"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace taxel::test
