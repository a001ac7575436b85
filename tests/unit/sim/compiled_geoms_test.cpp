// Sensors on geoms that MuJoCo copies, renames, moves or removes while it compiles a scene.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

constexpr const char* kReference = "objtype='geom' objname='ball'";

class CompiledGeoms : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }

  [[nodiscard]] static std::string sensor(const std::string& keys, const std::string& reference) {
    return "<extension><plugin plugin='taxel.sensor'/></extension><sensor><plugin name='t' plugin='taxel.sensor' " +
           reference + ">" + key("layout", "ball.taxels.json") + keys + "</plugin></sensor>";
  }
  /// Returns a scene of two balls, each with a pad, of which the second ones are 0.2 mm higher.
  [[nodiscard]] static std::string replicated(const std::string& keys, const std::string& reference) {
    std::string text = world();
    const std::string pad = "<geom name='pad' type='box' size='.01 .01 .001' pos='0 0 -.01'/>";
    text.replace(text.find("<body name"), 0, "<replicate count='2' offset='0.1 0 0.0002'>" + pad);
    text.replace(text.find("</body>"), 7, "</body></replicate>");
    return (keys.empty() ? "" : sensor(keys, reference)) + text;
  }
  /// Returns a scene whose ball is 0.5 mm in the floor, with further attributes of its mesh and geom.
  [[nodiscard]] static std::string world(const std::string& mesh = "", const std::string& ball = "",
                                         const std::string& compiler = "") {
    return "<option gravity='0 0 0'/>" + compiler + "<asset><mesh name='ball' file='ball.obj' " + mesh +
           "/></asset><worldbody><geom name='floor' type='plane' size='1 1 1'/><body name='b' pos='0 0 0.0195'>"
           "<freejoint/><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0' " +
           ball + "/><geom name='core' type='sphere' size='.001'/></body></worldbody>";
  }
  void compile(const std::string& text) { s.compile("<mujoco>" + text + "</mujoco>"); }
  void expect_refusal(const std::vector<std::string>& words) const {
    EXPECT_EQ(s.model, nullptr);
    for (const std::string& word : words)
      EXPECT_NE(s.error.find(word), std::string::npos) << word << " in: " << s.error;
  }
  [[nodiscard]] std::filesystem::path write(const std::string& xml) const {
    write_file_atomically(s.folder / "scene.xml", "<mujoco>" + xml + "</mujoco>");
    return s.folder / "scene.xml";
  }

  SensorScene s;
};

TEST_F(CompiledGeoms, EachReplicateHasItsOwnSensor) {
  for (const std::string& geom : {std::string(), key("geom", "ball")}) {
    compile(replicated(geom + key("others", "floor pad"), kReference));
    ASSERT_NE(s.model, nullptr) << s.error;
    ASSERT_EQ(s.model->nsensor, 2);
    mj_forward(s.model.get(), s.data.get());
    EXPECT_EQ(s.sensor(0).config().geom_name, "ball0");
    EXPECT_EQ(s.sensor(1).config().geom_name, "ball1");
    EXPECT_EQ(s.sensor(0).touched()[1].geom, mj_name2id(s.model.get(), mjOBJ_GEOM, "pad0"));
    EXPECT_EQ(s.sensor(1).touched()[1].geom, mj_name2id(s.model.get(), mjOBJ_GEOM, "pad1"));
    EXPECT_GT(s.data->sensordata[0], 1.2 * s.data->sensordata[1]) << "the second ball is 0.2 mm higher";
    EXPECT_GT(s.data->sensordata[1], 0);
  }
}

TEST_F(CompiledGeoms, AReplicatedGeomNeedsAReference) {
  compile(replicated(key("geom", "ball") + key("others", "floor"), ""));
  expect_refusal({"no geom named \"ball\"", "\"ball0\"", "<replicate>", "objname=\"ball\""});
}

TEST_F(CompiledGeoms, AReferencePoseIsRefusedWithThePoseToUse) {
  const std::string keys = key("geom", "ball") + key("others", "floor");
  for (const char* mesh : {"refpos='0 0 0.001'", "refquat='1 1 0 0'", "refpos='0.001 0.002 0' refquat='1 0 0 -1'"}) {
    compile(sensor(keys, "") + world(mesh, "pos='0 0 0.0002' quat='1 0 1 0'"));
    expect_refusal({"mesh \"ball\" of geom \"ball\" has refpos or refquat"});
    const std::size_t pose = s.error.find("pos=\""), end = s.error.find(" in its body");
    ASSERT_NE(end, std::string::npos) << s.error;
    const std::string stated = s.error.substr(pose, end - pose);
    compile(sensor(keys, "") + world("", stated));
    ASSERT_NE(s.model, nullptr) << s.error;
    EXPECT_TRUE(s.sensor().warnings().empty()) << s.sensor().warnings()[0];
  }
  compile(sensor(keys, "") + world("refpos='0 0 0' refquat='1 0 0 0'"));
  ASSERT_NE(s.model, nullptr) << s.error;
}

TEST_F(CompiledGeoms, ARemovedGeomIsNamedWithTheRemedy) {
  const std::string keys = key("geom", "ball") + key("others", "floor");
  const std::string discarding = world("", "", "<compiler discardvisual='true'/>");
  compile(sensor(keys, "") + discarding);
  expect_refusal({"no geom named \"ball\"", "discardvisual", "objname=\"ball\""});
  compile(sensor(keys, kReference) + discarding);
  ASSERT_NE(s.model, nullptr) << s.error;
  compile(sensor(keys, "") + world());
  ASSERT_NE(s.model, nullptr) << s.error;
}

TEST_F(CompiledGeoms, LoadedScenesKeepDrawnGeoms) {
  const std::string layout = (s.folder / "ball.taxels.json").string();
  const std::string discarding = world("", "", "<compiler discardvisual='true'/>");
  register_sensor_plugin();
  for (const bool is_attached : {false, true}) {
    const std::string own = is_attached ? "" : sensor(key("geom", "ball") + key("others", "floor"), "");
    std::vector<SceneAttachment> attachments;
    if (is_attached) attachments = {{"ball", layout}};
    const CompiledScene scene = load_scene(write(own + discarding), attachments);
    EXPECT_GE(mj_name2id(scene.model.get(), mjOBJ_GEOM, "ball"), 0);
  }
}

TEST_F(CompiledGeoms, LoadedScenesTakeLayoutsOnReplicates) {
  const auto simulator =
      Simulator::load(write(replicated("", "")), {{"ball1", (s.folder / "ball.taxels.json").string()}});
  export_scene(*simulator, s.folder / "copy");
  const auto copy = Simulator::load(s.folder / "copy/scene.xml");
  for (const auto& one : {simulator.get(), copy.get()}) {
    one->step();
    ASSERT_EQ(one->scene()->sensors.size(), 1U);
    EXPECT_EQ(one->scene()->sensor_geoms[0], "ball1");
    EXPECT_GT(row_of(one->view()).sensors[0].readings[0], 0);
  }
}

TEST_F(CompiledGeoms, LoadedScenesRefuseTheInstanceOfReplicates) {
  std::string scene = replicated(key("geom", "ball"), kReference);
  const std::string plugin = "<plugin plugin='taxel.sensor'/>";
  scene.replace(scene.find(plugin), plugin.size(), "<plugin plugin='taxel.sensor'><instance name='tip'/></plugin>");
  const std::string error = complaint_of([&] { load_scene(write(scene), {}); });
  EXPECT_NE(error.find("<replicate>"), std::string::npos) << error;
  EXPECT_NE(error.find("\"tip\""), std::string::npos) << error;
}

TEST_F(CompiledGeoms, LoadedScenesRefuseAReferencePose) {
  const std::filesystem::path scene = write(world("refpos='0 0 0.001'"));
  const std::string error = complaint_of([&] {
    Simulator::load(scene, {{"ball", (s.folder / "ball.taxels.json").string()}});
  });
  EXPECT_TRUE(error.starts_with(scene.string() + ": ")) << error;
  EXPECT_NE(error.find("has refpos or refquat"), std::string::npos) << error;
}

}  // namespace
}  // namespace taxel::test
