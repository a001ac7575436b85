// Functions of MuJoCo's viewer: frames, labels, cameras of the scene, tracking, groups of sites, info, profiler.
#include <gtest/gtest.h>

#include <cmath>

#include "script_lines.h"
#include "ui/scene/camera.h"
#include "ui/scene/passes/look.h"

namespace taxel::test {
namespace {

/// An arm that swings about y. Its palm, on a wrist without geoms, has a site above it and a camera that looks at it.
constexpr const char* kArm = R"(<mujoco><option><flag energy='enable'/></option><statistic center='0 0 .1' extent='.5'/>
  <visual><global azimuth='60' elevation='-30'/></visual><worldbody>
  <geom name='floor' type='plane' size='1 1 .1' pos='0 0 -.3'/>
  <camera name='top' pos='.1 0 .8' fovy='30'/><camera name='side' pos='0 -.8 .1' xyaxes='0 0 -1 1 0 0'/>
  <body name='arm' pos='0 0 .1'><joint name='shoulder' axis='0 1 0' damping='.02'/>
    <geom name='upper' type='capsule' fromto='0 0 0 .1 0 0' size='.02'/>
    <body name='wrist' pos='.1 0 0'><body name='palm' pos='.05 0 0'><geom name='block' type='box' size='.03 .02 .01'/>
      <site name='touch' pos='0 0 .03' size='.012' rgba='1 0 0 1' group='1'/>
      <site name='inner' pos='0 -.05 0' size='.012' rgba='1 0 0 1' group='4'/>
      <camera name='eye' pos='0 0 .2'/></body></body></body></worldbody></mujoco>)";

std::string shot(const std::string& name) {
  return R"({"do": "screenshot", "file": ")" + name + R"("})";
}
std::string mouse(const std::string& event, const Json& at, const std::string& button, const Json& mods) {
  Json line{{"event", event}, {"at", at}};
  if (event != "mouse_move") line.update({{"button", button}, {"mods", mods}});
  return line.dump();
}
std::string world(const dvec3& p) {
  return Json{{"world", {p.x, p.y, p.z}}}.dump();
}

ui::Camera camera_of(const Json& state) {
  const Json& from = state["camera"];
  ui::Camera camera;
  camera.target = vector_of(from["target"]);
  camera.azimuth_deg = from["azimuth_deg"];
  camera.elevation_deg = from["elevation_deg"];
  camera.distance = from["distance"];
  camera.fov_deg = from["fov_deg"];
  camera.roll_deg = from["roll_deg"];
  return camera;
}
/// Returns the pixel of a point of the world in the window.
dvec2 pixel_of(const Json& state, const dvec3& p_W) {
  const Json& view = state["view"];
  const dvec3 pixel = camera_of(state).project(p_W, view["width"], view["height"]);
  return {pixel.x + view["rect"][0].get<double>(), pixel.y + view["rect"][1].get<double>()};
}
Pose geom_pose(const Json& state, const std::string& name) {
  for (const Json& geom : state["scene"]["geoms"]) {
    const Json& q = geom["quaternion"];
    if (geom["name"] == name) return {dquat(q[0], q[1], q[2], q[3]), vector_of(geom["position"])};
  }
  ADD_FAILURE() << "no geom " << name;
  return {};
}
std::vector<std::string> label_texts(const Json& state) {
  std::vector<std::string> texts;
  for (const Json& label : state["labels"]) texts.push_back(label["text"]);
  std::sort(texts.begin(), texts.end());
  return texts;
}
bool has_colour(const Picture& picture, const dvec2& at, const glm::vec3& color, int tolerance) {
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      if (color_distance(picture.pixel(at.x + dx, at.y + dy), {color.x, color.y, color.z}) <= tolerance) return true;
  return false;
}
void expect_near(const dvec3& a, const dvec3& b, double tolerance) {
  EXPECT_NEAR(glm::distance(a, b), 0, tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << "; " << b.x << ' ' << b.y << ' ' << b.z;
}

bool has_widget(const Json& state, const char* panel, const char* label) {
  return std::any_of(state["widgets"].begin(), state["widgets"].end(),
                     [&](const Json& w) { return w["panel"] == panel && w["label"] == label; });
}

class Marks : public testing::Test {
 protected:
  /// Plays lines, paused at the start and without the glyphs of sensors.
  void play(const Lines& lines, const std::vector<std::string>& more = {}) const {
    write_text(studio_.folder() / "arm.xml", kArm);
    std::vector<std::string> arguments = more;
    arguments.emplace_back("arm.xml");
    studio_.play(joined({{kIdle, key("Space"), kIdle, key("Backspace"), kIdle}, lines}), arguments);
  }
  [[nodiscard]] Json state(const std::string& file) const { return studio_.state(file); }
  StudioProgram studio_;
};

TEST_F(Marks, CycleThroughLabelsAndFramesOfTheScene) {
  Lines lines;
  for (const char* kind : {"bodies", "joints", "geoms", "sites", "cameras", "none"})
    lines.insert(lines.end(), {key("F7"), kIdle, dump(std::string(kind) + ".json")});
  lines.insert(lines.end(), {dump("plain.json"), shot("plain.png")});
  for (const char* kind : {"bodies", "geoms", "sites", "world", "none"})
    lines.insert(lines.end(), {key("F6"), kIdle, dump(std::string("frames ") + kind + ".json"),
                               shot(std::string("frames ") + kind + ".png")});
  play(lines, {"--size", "1600x1000"});  // labels of bodies that are close to each other have room
  using Texts = std::vector<std::string>;
  EXPECT_EQ(label_texts(state("bodies.json")), (Texts{"arm", "palm", "wrist"}));
  EXPECT_EQ(label_texts(state("joints.json")), (Texts{"shoulder"}));
  EXPECT_EQ(label_texts(state("geoms.json")), (Texts{"block", "floor", "upper"}));
  EXPECT_EQ(label_texts(state("sites.json")), (Texts{"touch"})) << "group 4 is hidden";
  EXPECT_EQ(label_texts(state("none.json")), Texts{});
  const Json geoms = state("geoms.json");
  for (const Json& label : geoms["labels"]) {
    const dvec2 at = pixel_of(geoms, geom_pose(geoms, label["text"]).p);
    EXPECT_NEAR(label["pixel"][0].get<double>(), at.x, 1e-6) << label;
    EXPECT_NEAR(label["pixel"][1].get<double>(), at.y, 1e-6) << label;
  }
  const ui::Look& look = ui::look(true);
  const auto drawn = [&](const std::string& kind, const dvec3& p_W, const glm::vec3& color) {
    const Json at = state("frames " + kind + ".json");
    EXPECT_EQ(at["overlays"]["frames"], kind);
    return has_colour(studio_.picture("frames " + kind + ".png"), pixel_of(at, p_W), color, 40);
  };
  const dvec3 above_shoulder(0, 0, 0.13), above_world(0, 0, 0.02), above_touch(0.15, 0, 0.156);
  EXPECT_TRUE(drawn("bodies", above_shoulder, look.axis_z));
  EXPECT_FALSE(drawn("none", above_shoulder, look.axis_z));
  EXPECT_TRUE(drawn("sites", above_touch, look.axis_z));
  EXPECT_FALSE(drawn("none", above_touch, look.axis_z));
  EXPECT_TRUE(drawn("world", above_world, look.axis_z));
  EXPECT_FALSE(drawn("bodies", above_world, look.axis_z));
  EXPECT_EQ(file_text(studio_.folder() / "plain.png"), file_text(studio_.folder() / "frames none.png"));
}

TEST_F(Marks, ShowTheCamerasOfTheSceneUntilEsc) {
  const Json from{600, 250}, to{700, 200};
  play({dump("free.json"),
        key("]"),
        kIdle,
        dump("top.json"),
        mouse("mouse_down", from, "left", Json::array()),
        mouse("mouse_move", to, "left", Json::array()),
        kIdle,
        mouse("mouse_up", to, "left", Json::array()),
        kIdle,
        dump("dragged.json"),
        key("]"),
        kIdle,
        dump("side.json"),
        key("["),
        kIdle,
        key("["),
        kIdle,
        dump("eye.json"),
        key("Right"),
        kIdle,
        key("Right"),
        kIdle,
        dump("first.json"),
        key("Space"),
        R"({"do": "wait_time", "time": 0.2})",
        key("Space"),
        kIdle,
        dump("swung.json"),
        key("Left"),
        kIdle,
        dump("before.json"),
        shot("eye.png"),
        key("Escape"),
        kIdle,
        dump("escaped.json")});
  const Json top = state("top.json"), eye = state("eye.json"), swung = state("swung.json");
  EXPECT_EQ(top["followed"], "Camera top   [ ] others, Esc frees");
  expect_near(camera_of(top).eye(), {0.1, 0, 0.8}, 1e-9);
  EXPECT_EQ(camera_of(top).fov_deg, 30);
  const dvec2 middle = pixel_of(top, {0.1, 0, 0}), right = pixel_of(top, {0.2, 0, 0}),
              up = pixel_of(top, {0.1, 0.1, 0});
  EXPECT_GT(right.x, middle.x + 20);
  EXPECT_NEAR(right.y, middle.y, 1e-6);
  EXPECT_LT(up.y, middle.y - 20);
  EXPECT_EQ(state("dragged.json")["camera"], top["camera"]);
  const Json side = state("side.json");  // rotated: its right direction points down
  expect_near(camera_of(side).eye(), {0, -0.8, 0.1}, 1e-9);
  EXPECT_GT(pixel_of(side, {0, 0, 0}).x, pixel_of(side, {0, 0, 0.1}).x + 20);
  EXPECT_EQ(eye["followed"], "Camera eye   [ ] others, Esc frees") << "the one before the first is the last";
  for (const char* file : {"eye.json", "first.json", "swung.json", "before.json"}) {
    const Json at = state(file);
    expect_near(camera_of(at).eye(), geom_pose(at, "block") * dvec3(0, 0, 0.2), 1e-9);
  }
  EXPECT_NE(eye["camera"], swung["camera"]);
  EXPECT_NE(state("before.json")["camera"], swung["camera"]) << "a step of the past";
  EXPECT_EQ(state("escaped.json")["camera"], state("free.json")["camera"]);
  EXPECT_EQ(state("escaped.json")["followed"], "");
}

TEST_F(Marks, AlignTheCameraAndTrackABody) {
  const Json ctrl = {"ctrl"};
  const std::string block = world({0.15, 0, 0.1});
  play({key("A", kCtrl),
        kIdle,
        dump("aligned.json"),
        mouse("double_click", Json::parse(block), "right", ctrl),
        kIdle,
        kIdle,
        dump("tracked.json"),
        key("Space"),
        R"({"do": "wait_time", "time": 0.15})",
        key("Space"),
        kIdle,
        dump("swung.json"),
        mouse("double_click", Json::parse(world({-0.3, 0.3, -0.3})), "right", Json::array()),
        kIdle,
        dump("centred.json"),
        key("Home"),
        kIdle,
        key("A", kCtrl),
        kIdle,
        dump("again.json")});
  const ui::Camera aligned = camera_of(state("aligned.json"));
  expect_near(aligned.target, {0, 0, 0.1}, 1e-9);
  EXPECT_NEAR(std::remainder(aligned.azimuth_deg - 240, 360), 0, 1e-4) << "it looks to 60 degrees";
  EXPECT_NEAR(aligned.elevation_deg, 30, 1e-4);
  EXPECT_NEAR(aligned.distance * std::tan(glm::radians(0.5 * aligned.fov_deg)), 0.75 * std::tan(glm::radians(22.5)),
              1e-6);
  EXPECT_EQ(state("again.json")["camera"], state("aligned.json")["camera"]);
  const Json tracked = state("tracked.json"), swung = state("swung.json");
  EXPECT_EQ(tracked["followed"], "Tracks palm   Esc frees");
  const dvec3 in_block = geom_pose(tracked, "block").inverse() * camera_of(tracked).target;
  EXPECT_LT(glm::length(in_block), 0.05) << "on its surface";
  expect_near(camera_of(swung).target, geom_pose(swung, "block") * in_block, 1e-9);
  EXPECT_GT(glm::distance(camera_of(swung).target, camera_of(tracked).target), 0.01);
  EXPECT_EQ(camera_of(swung).azimuth_deg, camera_of(tracked).azimuth_deg);
  EXPECT_EQ(state("centred.json")["followed"], "");
}

TEST_F(Marks, SelectParentsByPageUpAndMoveByCtrlAlt) {
  const Json mods = {"ctrl", "alt"};
  play({R"({"event": "double_click", "at": )" + world({0.15, 0, 0.1}) + "}", kIdle, dump("palm.json"), key("PageUp"),
        kIdle, dump("wrist.json"), key("PageUp"), kIdle, dump("arm.json"), key("PageUp"), kIdle, dump("top.json"),
        mouse("mouse_down", {600, 300}, "left", mods), mouse("mouse_move", {640, 300}, "left", mods), kIdle,
        dump("moved.json"), mouse("mouse_up", {640, 300}, "left", mods), kIdle, dump("let_go.json")});
  EXPECT_EQ(state("palm.json")["scene"]["body"], "palm");
  EXPECT_EQ(state("wrist.json")["scene"]["body"], "wrist") << "it has no geom";
  EXPECT_EQ(state("arm.json")["scene"]["body"], "arm");
  EXPECT_EQ(state("top.json")["scene"]["body"], "arm") << "it hangs on the world";
  const Json hand = state("moved.json")["scene"]["hand"];
  ASSERT_TRUE(hand.is_object());
  EXPECT_FALSE(hand["turns"]);
  expect_near(vector_of(hand["grabbed"]), {0, 0, 0.1}, 1e-9);
  EXPECT_GT(glm::distance(vector_of(hand["at"]), vector_of(hand["grabbed"])), 0.005);
  EXPECT_EQ(state("moved.json")["camera"], state("top.json")["camera"]);
  EXPECT_TRUE(state("let_go.json")["scene"]["hand"].is_null());
}

TEST_F(Marks, ShowGroupsOfSitesAndKeepTheSetting) {
  const std::vector<std::string> keeps{"--state-dir", "state"};
  play({dump("at_first.json"), shot("at_first.png"), key("1", kShift), key("4", kShift), key("3"), key("F6"), kIdle,
        dump("other.json"), shot("other.png")},
       keeps);
  play({dump("next.json")}, keeps);
  const Json at_first = state("at_first.json"), other = state("other.json");
  const auto red = [&](const std::string& file, const dvec3& p_W) {  // a highlight of the lights may be on it
    const auto pixel = studio_.picture(file).pixel(pixel_of(at_first, p_W).x, pixel_of(at_first, p_W).y);
    return pixel[0] > 100 && std::max(pixel[1], pixel[2]) < pixel[0] / 2;
  };
  const dvec3 touch(0.15, 0, 0.13), inner(0.15, -0.05, 0.1);
  EXPECT_TRUE(red("at_first.png", touch));
  EXPECT_FALSE(red("at_first.png", inner));
  EXPECT_FALSE(red("other.png", touch));
  EXPECT_TRUE(red("other.png", inner));
  EXPECT_EQ(other["overlays"]["site_groups"], Json({true, false, true, false, true, false}));
  EXPECT_EQ(other["overlays"]["geom_groups"], Json({true, true, true, true, false, false}));
  for (const char* kept : {"site_groups", "geom_groups", "frames"})
    EXPECT_EQ(state("next.json")["overlays"][kept], other["overlays"][kept]) << kept;
}

TEST_F(Marks, ShowInfoOfTheDisplayedStepAndToggleFullScreen) {
  play({key("F2"),
        key("F11"),
        key("Right"),
        kIdle,
        dump("on.json"),
        shot("on.png"),
        key("Space"),
        R"({"do": "wait_time", "time": 0.1})",
        key("Space"),
        kIdle,
        dump("later.json"),
        key("Right"),
        kIdle,
        key("Left"),
        kIdle,
        dump("past.json"),
        key("F2"),
        key("F5"),
        kIdle,
        dump("off.json")});
  const Json on = state("on.json"), info = on["info"], later = state("later.json")["info"];
  EXPECT_EQ(info["Size"], "3 bodies, 3 geoms, 1 DOF");
  EXPECT_EQ(info["Contacts"], "0 of MuJoCo, 0 constraints");
  EXPECT_EQ(info["Time"], "0.0000 s, step 1 of 2 ms");
  EXPECT_NE(info["Solver"].get<std::string>().find("Newton, "), std::string::npos);
  const auto energy = [](const Json& rows) {
    double potential = 0, kinetic = 0;
    const auto text = rows["Energy"].get<std::string>();
    EXPECT_EQ(std::sscanf(text.c_str(), "potential %lf J, kinetic %lf J", &potential, &kinetic), 2) << text;
    return std::pair(potential, kinetic);
  };
  EXPECT_LT(energy(info).second, 1e-6) << "at rest";
  EXPECT_GT(energy(later).second, 1e-4) << "it falls";
  EXPECT_LT(energy(later).first, energy(info).first);
  for (const char* row : {"Time", "Contacts", "Solver", "Energy", "Memory"})
    EXPECT_EQ(state("past.json")["info"][row], later[row]) << "recorded with the step";
  EXPECT_TRUE(on["full_screen"]);
  EXPECT_FALSE(state("off.json")["full_screen"]);
  EXPECT_TRUE(state("off.json")["info"].is_null());
}

/// Offscreen there is no screen to fill, so frames keep their size.
TEST_F(Marks, FillTheScreenAndRestoreTheWindow) {
  play({shot("before.png"), key("F11"), kIdle, kIdle, kIdle, shot("full.png"), key("F5"), kIdle, kIdle, kIdle,
        shot("after.png"), key("F11"), kIdle, kIdle, kIdle, shot("again.png")});
  const Picture before = studio_.picture("before.png"), full = studio_.picture("full.png"),
                after = studio_.picture("after.png");
  EXPECT_EQ(full.width > before.width, in_a_window());
  EXPECT_EQ(full.height > before.height, in_a_window());
  EXPECT_EQ(after.width, before.width);
  EXPECT_EQ(after.height, before.height);
  EXPECT_EQ(studio_.picture("again.png").width, full.width);
}

TEST_F(Marks, ShowTheTimesOfTheProfiler) {
  const StudioProgram& studio = studio_;
  studio.play({kIdle, key("F3"), R"({"do": "wait_for", "pointer": "/profile/steps", "least": 100})",
               R"({"do": "wait_for", "pointer": "/profile/pictures", "least": 10})", dump("live.json"),
               shot("live.png"), R"({"event": "mouse_move", "at": {"widget": "Taxels over travel tab"}})", kIdle,
               press("Taxels over travel tab"), kIdle, dump("plot.json")},
              {"--live", kLayoutFile});
  studio.play({kIdle, key("F3"), kIdle, kIdle, dump("scripted.json"), shot("scripted.png"),
               R"({"event": "mouse_move", "at": {"widget": "Taxels over time tab"}})", kIdle,
               press("Taxels over time tab"), kIdle, dump("over_time.json")},
              {TAXEL_SOURCE_DIR "/assets/scenes/press.xml"});
  const Json live = state("live.json"), profile = live["profile"];
  for (const char* part : {"mujoco", "surfaces", "forces", "readings", "history", "panels", "scene", "window"})
    EXPECT_GT(profile[part].get<double>(), 0) << part;
  double step = 0;
  for (const char* part : {"mujoco", "surfaces", "forces", "readings", "history"}) step += profile[part].get<double>();
  EXPECT_LT(step, 1) << "seconds, not their sum";
  EXPECT_TRUE(has_widget(live, "Profiler", "A step"));
  EXPECT_TRUE(has_widget(live, "Profiler", "A picture"));
  EXPECT_TRUE(has_widget(state("plot.json"), "Taxels over travel", "Plot"));
  EXPECT_TRUE(has_widget(state("scripted.json"), "Profiler", "No times"));
  EXPECT_TRUE(has_widget(state("over_time.json"), "Taxels over time", "Plot"));
  EXPECT_FALSE(has_widget(state("scripted.json"), "Profiler", "A step"))
      << "pictures of a script are the same every time";
}

}  // namespace
}  // namespace taxel::test
