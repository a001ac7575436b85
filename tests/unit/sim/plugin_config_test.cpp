// Configuration of the plugin in a scene: every mistake is a compile error that names it.
#include <gtest/gtest.h>

#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr const char* kWorld = R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
    <geom name='floor' type='plane' size='1 1 1'/>
    <geom name='hills' type='hfield' hfield='hills' pos='9 9 -9'/>
    <body name='b' pos='0 0 0.019'><freejoint/><geom name='ball' type='mesh' mesh='ball'/></body>
    <body pos='1 0 0'><freejoint/><geom name='box' type='box' size='.01 .01 .01'/></body></worldbody></mujoco>)";
constexpr const char* kHead = "<mujoco><asset><hfield name='hills' nrow='2' ncol='2' size='1 1 1 1'/></asset>";

class PluginConfig : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }

  void compile(const std::string& extension) { s.compile(kHead + extension + kWorld); }
  /// Returns the plugin element with exactly these keys.
  static std::string with(const std::string& keys) {
    return "<extension><plugin plugin='taxel.sensor'><instance name='ball'>" + keys +
           "</instance></plugin></extension><sensor><plugin name='t' plugin='taxel.sensor' instance='ball'/></sensor>";
  }
  void expect_error(const std::string& extension, const std::vector<std::string>& words) {
    compile(extension);
    EXPECT_EQ(s.model, nullptr);
    for (const std::string& word : words)
      EXPECT_NE(s.error.find(word), std::string::npos) << word << " in: " << s.error;
  }
  std::string layout_path() const { return (s.folder / "ball.taxels.json").string(); }

  SensorScene s;
};

TEST_F(PluginConfig, TouchesCollidingGeomsByDefault) {
  compile(sensor_extension("ball"));
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.sensor().touched().size(), 3u);  // floor, height field and box
  EXPECT_EQ(s.sensor().touched()[0].geom, mj_name2id(s.model.get(), mjOBJ_GEOM, "floor"));
  EXPECT_TRUE(s.sensor().warnings().empty());
  EXPECT_EQ(s.model->nsensordata, 1);
  EXPECT_DOUBLE_EQ(s.sensor().touched()[0].properties.friction, 2 * 0.5 * 1.0 / 1.5);  // MuJoCo's default friction is 1
  EXPECT_DOUBLE_EQ(s.sensor().touched()[0].properties.dissipation, 5);
}

/// Returns the scene with a ball that is only drawn, and with other geoms on its body.
std::string drawn_ball(const std::string& sisters, const std::string& after = "") {
  std::string world = kWorld;
  const std::string geom = "<geom name='ball' type='mesh' mesh='ball'/>";
  world.replace(world.find(geom), geom.size(),
                "<geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/>" + sisters);
  return world.insert(world.find("</mujoco>"), after);
}

TEST_F(PluginConfig, TouchesAllThatTheBodyOfADrawnGeomCanTouch) {
  const std::string extension = kHead + sensor_extension("ball"), core = "<geom name='core' type='sphere' size='.01'/>";
  const auto touched = [&](const std::string& world) {
    s.compile(extension + world);
    EXPECT_NE(s.model, nullptr) << s.error;
    std::vector<std::string> names;
    if (s.model != nullptr)
      for (const TouchedGeom& one : s.sensor().touched())
        names.emplace_back(s.model->names + s.model->name_geomadr[one.geom]);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(touched(drawn_ball(core)), (Names{"floor", "hills", "box"}));
  EXPECT_EQ(touched(drawn_ball(core, "<contact><exclude body1='b' body2='world'/></contact>")), (Names{"box"}));
  EXPECT_EQ(touched(drawn_ball("", "<contact><pair geom1='box' geom2='ball'/></contact>")), (Names{"box"}));
  EXPECT_EQ(touched(drawn_ball("")), (Names{"floor", "hills", "box"})) << "a body without collisions touches all";
}

TEST_F(PluginConfig, TouchesGeomsByTheBitsOfTheSkin) {
  std::string world = drawn_ball("<geom name='core' type='sphere' size='.01' contype='0' conaffinity='0'/>");
  world.insert(world.find("name='box'"), "contype='4' conaffinity='0' ");
  const auto touched = [&](const std::string& keys, const std::string& after = "") {
    std::string text = kHead + sensor_extension("ball", keys) + world;
    s.compile(text.insert(text.rfind("</mujoco>"), after));
    EXPECT_NE(s.model, nullptr) << s.error;
    std::vector<std::string> names;
    if (s.model != nullptr)
      for (const TouchedGeom& one : s.sensor().touched())
        names.emplace_back(s.model->names + s.model->name_geomadr[one.geom]);
    return names;
  };
  using Names = std::vector<std::string>;
  const std::string ground = "<contact><exclude body1='b' body2='world'/></contact>";
  EXPECT_EQ(touched(key("contype", "1") + key("conaffinity", "0")), (Names{"floor", "hills"}));
  EXPECT_EQ(touched(key("contype", "1") + key("conaffinity", "4")), (Names{"floor", "hills", "box"}));
  EXPECT_EQ(touched(key("conaffinity", "4")), (Names{"box"}));
  EXPECT_EQ(touched(key("contype", "1") + key("conaffinity", "4"), ground), (Names{"box"}));
  EXPECT_EQ(touched(key("contype", "1") + key("others", "box")), (Names{"box"})) << "names replace the bits";
}

TEST_F(PluginConfig, TouchesTheSkinOfAnotherSensorByItsBits) {
  const std::string sensors = "<extension><plugin plugin='taxel.sensor'><instance name='a'>" +
                              key("layout", "ball.taxels.json") + key("geom", "a") + key("contype", "2") +
                              "</instance><instance name='b'>" + key("layout", "ball.taxels.json") + key("geom", "b") +
                              key("conaffinity", "2") + "</instance></plugin></extension><sensor>" +
                              "<plugin name='a' plugin='taxel.sensor' instance='a'/><plugin name='b' "
                              "plugin='taxel.sensor' instance='b'/></sensor>";
  const auto ball = [](const std::string& name) {
    return "<body pos='" + std::string(name == "a" ? "0" : ".03") + " 0 0'><freejoint/><geom name='" + name +
           "' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>";
  };
  s.compile("<mujoco>" + sensors +
            "<asset><mesh name='ball' file='ball.obj'/></asset><worldbody><geom name='floor' "
            "type='plane' size='1 1 1' contype='4' conaffinity='4'/>" +
            ball("a") + ball("b") + "</worldbody></mujoco>");
  ASSERT_NE(s.model, nullptr) << s.error;
  for (const int i : {0, 1}) {
    ASSERT_EQ(s.sensor(i).touched().size(), 1U) << i;
    EXPECT_EQ(s.sensor(i).touched()[0].geom, 2 - i);
  }
}

TEST_F(PluginConfig, RefusesASensorThatCanTouchNothing) {
  std::string world = drawn_ball("");
  for (const char* other : {"name='floor'", "name='hills'", "name='box'"})
    world.insert(world.find(other), "contype='0' conaffinity='0' ");
  s.compile(kHead + sensor_extension("ball") + world);
  EXPECT_EQ(s.model, nullptr);
  EXPECT_NE(s.error.find("others: no geom can touch geom \"ball\" or another geom of its body \"b\": give one of them "
                         "contype and conaffinity"),
            std::string::npos)
      << s.error;
}

TEST_F(PluginConfig, TakesASensorThatIsAlone) {
  s.compile("<mujoco>" + sensor_extension("ball") +
            "<asset><mesh name='ball' file='ball.obj'/></asset><worldbody><body name='b'><freejoint/>"
            "<geom name='ball' type='mesh' mesh='ball'/></body></worldbody></mujoco>");
  ASSERT_NE(s.model, nullptr) << s.error << ": others are attached to this scene later";
  EXPECT_TRUE(s.sensor().touched().empty());
}

TEST_F(PluginConfig, ReadsGeomsByTheirIds) {
  compile(sensor_extension("ball", key("other_ids", "3 0 3")));
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.sensor().touched().size(), 2U);
  EXPECT_EQ(s.sensor().touched()[0].geom, 0);
  EXPECT_EQ(s.sensor().touched()[1].geom, 3);
  expect_error(sensor_extension("ball", key("other_ids", "4")), {"other_ids", "must be ids of the 4 geoms, has \"4\""});
  expect_error(sensor_extension("ball", key("other_ids", "1") + key("others", "box")), {"other_ids", "excludes"});
}

TEST_F(PluginConfig, NamesGeomsThatCannotBeTouchedInAWarning) {
  compile(sensor_extension("ball", key("materials", "{\"hills\": {\"modulus\": 1e5}}")));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(s.sensor().touched().size(), 2u);
  ASSERT_EQ(s.sensor().warnings().size(), 1u);
  EXPECT_NE(s.sensor().warnings()[0].find("hills"), std::string::npos);
  EXPECT_NE(s.sensor().warnings()[0].find("can only be rigid"), std::string::npos);
}

TEST_F(PluginConfig, RefusesMistakesByCompileErrorsThatNameThem) {
  const std::string layout = key("layout", "ball.taxels.json"), geom = key("geom", "ball");
  expect_error(with(layout), {"geom", "required"});
  expect_error(with(geom), {"layout", "required"});
  expect_error(with(layout + key("geom", "bal")), {"geom", "\"bal\""});
  expect_error(with(layout + geom + key("other", "floor")), {"other"});
  expect_error(with(layout + geom + key("others", "floor bx")), {"others", "\"bx\""});
  expect_error(with(layout + geom + key("others", "ball")), {"others", "\"ball\""});
  expect_error(with(layout + geom + key("others", "hills") + key("materials", "{\"hills\": {\"modulus\": 1e5}}")),
               {"others", "hills", "can only be rigid"});
  for (const char* mask : {"-1", "x", "1.5", "99999999999"})
    expect_error(with(layout + geom + key("contype", mask)), {"contype", "whole number", mask});
  expect_error(with(layout + geom + key("force", "push")), {"force", "\"push\"", "sense"});
  expect_error(with(layout + geom + key("output", "readings shear")), {"output", "\"shear\"", "wrench"});
  expect_error(with(layout + geom + key("materials", "{\"box\": 3}")), {"materials", "/box", "object"});
  expect_error(with(layout + geom + key("materials", "{\"box\": {\"modulus\": -1}}")), {"/box/modulus", "-1"});
  expect_error(with(layout + geom + key("materials", "{\"box\": {\"colour\": 1}}")), {"/box/colour"});
  expect_error(with(layout + geom + key("materials", "{\"bax\": {}}")), {"materials", "\"bax\""});
  expect_error(with(layout + geom + key("materials", "{")), {"materials", "line 1"});
  expect_error(with(layout + geom + key("taxels", "1")), {"taxels", "layout"});
  expect_error(with(geom + key("taxels", "many")), {"taxels", "many"});
}

TEST_F(PluginConfig, NamesFileAndPlaceOfAWrongLayout) {
  expect_error(with(key("layout", "nothing.taxels.json") + key("geom", "ball")),
               {"nothing.taxels.json", "folders tried", s.folder.string(), std::filesystem::current_path().string()});
  write_file_atomically(s.folder / "wrong.taxels.json", "{\"format\": \"taxel-layout\", \"version\": 7}");
  expect_error(with(key("layout", "wrong.taxels.json") + key("geom", "ball")), {"wrong.taxels.json", "7"});
  Layout layout = read_layout(layout_path());
  layout.taxels[0].radius = -1;
  write_layout(s.folder / "radius.taxels.json", layout);
  expect_error(with(key("layout", "radius.taxels.json") + key("geom", "ball")), {"/taxels/0/radius", "-1"});
  layout = read_layout(layout_path());
  layout.mesh.file = "gone.obj";
  write_layout(s.folder / "mesh.taxels.json", layout);
  expect_error(with(key("layout", "mesh.taxels.json") + key("geom", "ball")), {"gone.obj"});
}

TEST_F(PluginConfig, FindsLayoutsByAbsolutePathNearTheMeshAndInTheFolder) {
  compile(with(key("layout", layout_path()) + key("geom", "ball")));
  EXPECT_NE(s.model, nullptr) << s.error;
  compile(with(key("layout", "ball.taxels.json") + key("geom", "ball")));
  EXPECT_NE(s.model, nullptr) << s.error;
  std::filesystem::create_directory(s.folder / "elsewhere");
  write_file_atomically(s.folder / "elsewhere" / "moved.taxels.json", read_file(layout_path()));
  write_file_atomically(s.folder / "elsewhere" / "ball.obj", read_file(s.folder / "ball.obj"));
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(s.folder / "elsewhere");
  compile(with(key("layout", "moved.taxels.json") + key("geom", "ball")));
  std::filesystem::current_path(before);
  EXPECT_NE(s.model, nullptr) << s.error;
}

TEST_F(PluginConfig, ReadsTheLayoutTextOfAnIncludedFile) {
  std::string text = read_file(layout_path());
  std::string escaped;
  for (const char c : text) escaped += c == '"' ? std::string("&quot;") : std::string(1, c);
  write_file_atomically(s.folder / "taxels.xml", "<mujoco><config key=\"layout\" value=\"" + escaped + "\"/></mujoco>");
  compile(with("<include file='taxels.xml'/>" + key("geom", "ball")));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(s.sensor().model()->layout.name, "one taxel");
}

TEST_F(PluginConfig, WritesOutputsInTheRequestedOrder) {
  compile(sensor_extension("ball", key("output", "area wrench readings") + key("others", "floor")));
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.model->nsensordata, 8);
  s.step();
  const mjtNum* out = s.data->sensordata;
  const Evaluation& e = s.sensor().sensed();
  const dvec3 force = e.X_WM.rotate(e.pairs[0].wrench.force), torque = e.X_WM.rotate(e.pairs[0].wrench.torque);
  EXPECT_GT(out[0], 0);
  EXPECT_EQ(out[0], e.pairs[0].surface.area());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(out[1 + i], force[i]);
    EXPECT_EQ(out[4 + i], torque[i]);
  }
  EXPECT_GT(out[3], 0);
  EXPECT_EQ(out[7], s.sensor().reading().values[0]);
  EXPECT_GT(out[7], 0);
}

TEST_F(PluginConfig, AppliesNoForceIfItOnlySenses) {
  compile(sensor_extension("ball", key("force", "sense")));
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(50);
  EXPECT_GT(s.data->sensordata[0], 0);
  for (int i = 0; i < s.model->nv; ++i) EXPECT_EQ(s.data->qfrc_passive[i], 0);
  EXPECT_TRUE(s.sensor().warnings().empty());  // MuJoCo's own contacts are wanted here
}

TEST_F(PluginConfig, ReportsMujocosOwnContactOfAPairOnce) {
  compile(sensor_extension("ball"));
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(20);
  ASSERT_EQ(s.sensor().warnings().size(), 1u);
  EXPECT_NE(s.sensor().warnings()[0].find("\"ball\""), std::string::npos);
  EXPECT_NE(s.sensor().warnings()[0].find("\"floor\""), std::string::npos);
}

TEST_F(PluginConfig, GivesNoWarningForADeepPress) {
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::pad, 5e4, 0.002, 5, 0.5});
  compile(sensor_extension("ball", key("others", "floor") + key("force", "sense")));
  ASSERT_NE(s.model, nullptr) << s.error;
  for (const double height : {0.019, 0.015}) {
    s.data->qpos[2] = height;
    mj_forward(s.model.get(), s.data.get());
    EXPECT_TRUE(s.sensor().warnings().empty()) << height;
  }
}

TEST_F(PluginConfig, ReportsAMeshThatIsNotTheLayouts) {
  save_mesh(s.folder / "other.obj", make_sphere(0.021, 0.008));
  std::string world = kWorld;
  world.replace(world.find("ball.obj"), 8, "other.obj");
  s.compile(kHead + sensor_extension("ball", key("others", "floor")) + world);
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.sensor().warnings().size(), 1u);
  EXPECT_NE(s.sensor().warnings()[0].find("up to 1 mm apart"), std::string::npos) << s.sensor().warnings()[0];
}

TEST_F(PluginConfig, RefusesABinaryModelOfALargerLayout) {
  compile(sensor_extension("ball"));
  ASSERT_NE(s.model, nullptr) << s.error;
  Layout layout = read_layout(layout_path());
  layout.taxels.push_back(layout.taxels[0]);
  layout.taxels[1].id = 1;
  layout.taxels[1].center = {0, 0.02, 0};
  layout.taxels[1].normal = {0, 1, 0};
  write_layout(layout_path(), layout);
  // Outside a compilation, MuJoCo ends the program if a plugin refuses.
  const auto make = [&] {
    mjLogConfig log = mju_getLogConfig();
    log.logto_console = true;
    mju_setLogConfig(log);
    const DataHandle data(mj_makeData(s.model.get()));
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(make(), testing::ExitedWithCode(1), "needs 2 values in sensordata");
}

}  // namespace
}  // namespace taxel
