// Patches of scenes: layouts that exist only in memory, primitives, URDF, and scenes that no patch describes. The
// scenes of tests/fixtures/scenes_to_patch are tested with `taxel attach`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/scene/scene_patch.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;
using test::SensorScene;

class ScenePatch : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }
  fs::path write(const std::string& content, const std::string& name = "scene.xml") const {
    write_file_atomically(s.folder / name, "<mujoco>\n" + content + "</mujoco>\n");
    return s.folder / name;
  }
  [[nodiscard]] std::string layout() const { return (s.folder / "ball.taxels.json").string(); }
  [[nodiscard]] PatchedScene patch(const fs::path& scene, const SceneAttachment& one, const fs::path& output) const {
    return patched_scene(scene, {one}, load_scene(scene, {one}), output);
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
  /// Returns the readings and forces of a run.
  static std::vector<double> run(Simulator& simulator) {
    std::vector<double> values;
    for (int n = 0; n < 100; ++n) {
      simulator.step();
      const RecordedRow row = row_of(simulator.view());
      values.insert(values.end(), row.sensors[0].readings.begin(), row.sensors[0].readings.end());
      values.push_back(row.sensors[0].force_W.z);
    }
    return values;
  }
  SensorScene s;
};

constexpr const char* kScene = R"(  <asset><mesh name="ball" file="ball.obj"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body name="b" pos="0 0 0.0195"><freejoint/><geom type="mesh" mesh="ball"/></body>
  </worldbody>
)";

TEST_F(ScenePatch, AppendsTheSensorAndTakesTheBitsOfItsGeom) {
  const PatchedScene patched = patch(write(kScene), {"", layout(), {}, "b"}, s.folder / "saved.xml");
  EXPECT_EQ(patched.scene.xml, R"(<mujoco>
  <asset><mesh name="ball" file="ball.obj"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body name="b" pos="0 0 0.0195"><freejoint/><geom name="b" type="mesh" mesh="ball" contype="0" conaffinity="0"/></body>
  </worldbody>
  <extension>
    <plugin plugin="taxel.sensor">
      <instance name="b">
        <config key="layout" value="ball.taxels.json"/>
        <config key="geom" value="b"/>
        <config key="contype" value="1"/>
        <config key="conaffinity" value="1"/>
      </instance>
    </plugin>
  </extension>
  <sensor>
    <plugin name="b taxels" plugin="taxel.sensor" instance="b" objtype="geom" objname="b"/>
  </sensor>
</mujoco>
)");
  EXPECT_TRUE(patched.scene.files.empty()) << "the layout is there";
  ASSERT_EQ(patched.sensors.size(), 1U);
  EXPECT_EQ(patched.sensors[0].sensor, "b taxels");
}

TEST_F(ScenePatch, SavesTheEditedLayoutOfARunningScene) {
  const fs::path scene = write(kScene);
  const auto running = Simulator::load(scene, {{"", layout(), {}, "b"}});
  Layout edited = read_layout(layout());
  edited.taxels[0].radius *= 0.8;
  edited.taxels.push_back(edited.taxels[0]);
  edited.taxels[1].id = 1;
  edited.taxels[1].center.x += 0.003;
  write_layout(s.folder / "edited.taxels.json", edited);
  // A layout with as many taxels replaces the one in use.
  edited.taxels.pop_back();
  write_layout(s.folder / "same_size.taxels.json", edited);
  running->replace_model(running->scene()->sensors[0], load_sensor_model(s.folder / "same_size.taxels.json"));
  EXPECT_EQ(save_scene(*running, s.folder / "saved.xml"), "");
  EXPECT_TRUE(fs::exists(s.folder / "saved_ball.taxels.json")) << "ball.taxels.json has other taxels";
  EXPECT_EQ(read_layout(s.folder / "saved_ball.taxels.json"), edited);
  running->reset();
  const auto saved = Simulator::load(s.folder / "saved.xml");
  EXPECT_EQ(run(*saved), run(*running));
}

/// A scene with two balls whose file declares their sensors: `layout` is the value of the key of both.
std::string two_declared_balls(const std::string& layout) {
  return R"(  <!-- two balls -->
  <extension>
    <plugin plugin='taxel.sensor'>
      <instance name="left"><config key="layout"   value=")" +
         layout + R"("/> <!-- kept --><config key="geom" value="left"/></instance>
      <instance name="right"><config key="layout" value=")" +
         layout + R"("/><config key="geom" value="right"/></instance>
    </plugin>
  </extension>
  <asset><mesh name="ball" file="ball.obj"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1" conaffinity="2"/>
    <body name="l" pos="0 0 0.0195"><freejoint/><geom name="left" type="mesh" mesh="ball" contype="2" conaffinity="0"/></body>
    <body name="r" pos="0.1 0 0.0195"><freejoint/><geom name="right" type="mesh" mesh="ball" contype="2" conaffinity="0"/></body>
  </worldbody>
  <contact><exclude body1="world" body2="l"/><exclude body1="world" body2="r"/></contact>
  <sensor><plugin plugin="taxel.sensor" instance="left"/><plugin plugin="taxel.sensor" instance="right"/></sensor>
)";
}

TEST_F(ScenePatch, WritesTheEditedLayoutOfDeclaredSensors) {
  const fs::path scene = write(two_declared_balls("ball.taxels.json"));
  const std::string text = read_file(scene), before = read_file(layout());
  Layout edited = read_layout(layout());
  edited.taxels[0].radius *= 0.8;
  write_layout(s.folder / "same_size.taxels.json", edited);
  edited.taxels.push_back(edited.taxels[0]);
  edited.taxels[1].id = 1;
  edited.taxels[1].center.x += 0.003;
  write_layout(s.folder / "two.taxels.json", edited);
  // With as many taxels the models of a running scene are replaced, otherwise it is loaded with other ones.
  const SensorModelPtr same_size = load_sensor_model(s.folder / "same_size.taxels.json");
  const SensorModelPtr two = load_sensor_model(s.folder / "two.taxels.json");
  const auto running = Simulator::load(scene);
  running->replace_model(running->scene()->sensors[0], same_size);
  const auto declared = [&](const std::string& geom) {
    SceneAttachment one{.geom = geom, .layout = layout(), .model = two};
    one.is_declared = true;
    return one;
  };
  const auto loaded = Simulator::load(scene, {declared("left"), declared("right")});
  ASSERT_EQ(loaded->scene()->sensors[1]->taxel_count(), 2);
  fs::create_directory(s.folder / "out");
  const std::string key = R"(key="layout"   value="ball.taxels.json")";
  for (const auto& [simulator, output] : {std::pair{running.get(), s.folder / "saved.xml"},
                                          {loaded.get(), s.folder / "loaded.xml"},
                                          {loaded.get(), s.folder / "out/loaded.xml"}}) {
    SCOPED_TRACE(output);
    simulator->reset();
    EXPECT_EQ(save_scene(*simulator, output), "");
    const auto saved = Simulator::load(output);
    EXPECT_EQ(saved->scene()->sensors[0], saved->scene()->sensors[1]) << "one file for both sensors";
    const std::vector<double> values = run(*saved);
    EXPECT_GT(values.back(), 0);
    EXPECT_EQ(values, run(*simulator));
  }
  std::string patched = text;  // all bytes but the two names stay
  for (std::size_t at = 0; (at = patched.find("ball.taxels.json", at)) != std::string::npos; at += 10)
    patched.insert(at, "saved_");
  EXPECT_EQ(read_file(s.folder / "saved.xml"), patched);
  EXPECT_EQ(read_file(scene), text);
  EXPECT_EQ(read_file(layout()), before) << "the scene that was loaded reads as before";
  // A layout that was saved in its own file needs no other name.
  write_file_atomically(layout(), read_file(s.folder / "two.taxels.json"));
  EXPECT_EQ(save_scene(*loaded, s.folder / "again.xml"), "");
  EXPECT_EQ(read_file(s.folder / "again.xml"), text);
}

TEST_F(ScenePatch, TurnsALayoutThatIsTextIntoAFile) {
  const auto as_text = [](const fs::path& file) {
    std::string text = read_file(file);
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos;) text.replace(at, 1, "&quot;");
    return text;
  };
  Layout edited = read_layout(layout());
  edited.taxels[0].radius *= 0.8;
  write_layout(s.folder / "edited.taxels.json", edited);
  write_file_atomically(s.folder / "left.xml",
                        R"(<mujoco><config key="layout" value=")" + as_text(layout()) + "\"/></mujoco>");
  std::string text = two_declared_balls("ball.taxels.json");
  text.replace(text.find("<config key=\"layout\"   value=\"ball.taxels.json\"/>"), 49, "<include file=\"left.xml\"/>");
  const fs::path scene = write(text);
  const std::string before = read_file(scene);
  const auto running = Simulator::load(scene);
  running->replace_model(running->scene()->sensors[0], load_sensor_model(s.folder / "edited.taxels.json"));
  running->reset();
  const std::vector<double> expected = run(*running);
  EXPECT_EQ(save_scene(*running, s.folder / "saved.xml"), "");
  EXPECT_TRUE(fs::exists(s.folder / "left.taxels.json"));
  EXPECT_EQ(run(*Simulator::load(s.folder / "saved.xml")), expected);
  // The scene itself names the file afterwards; only the included file with the text changes.
  const auto changed = with_layout_file(scene, {"left"}, s.folder / "edited.taxels.json");
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed.begin()->first.filename(), "left.xml");
  EXPECT_EQ(changed.begin()->second, R"(<mujoco><config key="layout" value="edited.taxels.json"/></mujoco>)");
  write_file_atomically(changed.begin()->first, changed.begin()->second);
  EXPECT_EQ(run(*Simulator::load(scene)), expected);
  EXPECT_EQ(read_file(scene), before);
  EXPECT_THROW(with_layout_file(scene, {"floor"}, s.folder / "edited.taxels.json"), Error);
}

TEST_F(ScenePatch, CopiesTheLayoutOfAnotherFolder) {
  fs::create_directory(s.folder / "layouts");
  fs::rename(layout(), s.folder / "layouts/ball.taxels.json");
  Layout moved = read_layout(s.folder / "layouts/ball.taxels.json");
  moved.mesh.file = "../ball.obj";
  write_layout(s.folder / "layouts/ball.taxels.json", moved);
  const SceneAttachment one{"", (s.folder / "layouts/ball.taxels.json").string(), {}, "b"};
  const fs::path scene = write(kScene);
  const std::vector<double> expected = run(*Simulator::load(scene, {one}));
  write_scene(s.folder / "out/saved.xml", patch(scene, one, s.folder / "out/saved.xml").scene);
  EXPECT_EQ(read_layout(s.folder / "out/ball.taxels.json").mesh.file, "../ball.obj");
  EXPECT_EQ(run(*Simulator::load(s.folder / "out/saved.xml")), expected);
  // The folders of scene and meshes are moved together.
  const fs::path moved_to = s.folder.string() + "_moved";
  fs::rename(s.folder, moved_to);
  EXPECT_EQ(run(*Simulator::load(moved_to / "out/saved.xml")), expected);
  fs::rename(moved_to, s.folder);
}

TEST_F(ScenePatch, GivesAPrimitiveInASceneWithoutMeshesItsSurface) {
  save_mesh(s.folder / "pad.obj", make_box({0.01, 0.01, 0.01}));
  write_layout(s.folder / "pad.taxels.json",
               test::one_taxel_layout("pad.obj", 0.01, {FieldKind::pad, 5e4, 0.004, 5, 0.5}));
  const fs::path scene = write(R"(  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body name="pad" pos="0 0 0.0095"><freejoint/><geom type="box" size=".01 .01 .01"/></body>
  </worldbody>
)");
  const SceneAttachment one{"geom 1", (s.folder / "pad.taxels.json").string()};
  const std::vector<double> expected = run(*Simulator::load(scene, {one}));
  EXPECT_GT(expected.back(), 0);
  for (const fs::path& output : {s.folder / "saved.xml", s.folder / "out/saved.xml"}) {
    write_scene(output, patch(scene, one, output).scene);
    EXPECT_EQ(run(*Simulator::load(output)), expected) << output;
  }
}

TEST_F(ScenePatch, MakesMjcfOfAUrdf) {
  fs::create_directory(s.folder / "meshes");
  fs::copy(s.folder / "ball.obj", s.folder / "meshes/ball.obj");
  write_file_atomically(s.folder / "robot.urdf", R"(<robot name="r"><link name="base"/><link name="tip"><inertial>
      <mass value=".1"/><inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial><collision>
      <geometry><mesh filename="package://r/meshes/ball.obj"/></geometry></collision></link>
      <joint name="j" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
      <limit lower="-.1" upper=".1" effort="1" velocity="1"/></joint><link name="cap"><collision><geometry>
      <sphere radius=".01"/></geometry></collision></link><joint name="f" type="fixed"><parent link="base"/>
      <child link="cap"/><origin xyz="0 0 0.029"/></joint></robot>)");
  const SceneAttachment one{"", layout(), {}, "tip"};
  const std::vector<double> expected = run(*Simulator::load(s.folder / "robot.urdf", {one}));
  const fs::path output = s.folder / "out/robot.xml";
  const PatchedScene patched = patch(s.folder / "robot.urdf", one, output);
  EXPECT_TRUE(has(patched.scene.xml, "\"../meshes/ball.obj\"")) << patched.scene.xml;
  write_scene(output, patched.scene);
  EXPECT_EQ(run(*Simulator::load(output)), expected);
}

TEST_F(ScenePatch, RefusesScenesThatTextCannotDescribe) {
  const auto complaint = [&](const std::string& content, const SceneAttachment& one) {
    return test::complaint_of([&] { static_cast<void>(patch(write(content), one, s.folder / "saved.xml")); });
  };
  std::string copies = kScene;
  copies.insert(copies.find("<body"), "<replicate count='2' offset='1 0 0'>");
  copies.insert(copies.find("</worldbody>"), "</replicate>");
  const std::string made = complaint(copies, {"geom 1", layout()});
  EXPECT_TRUE(has(made, "made by <replicate>")) << made;
  const std::string fields = "<custom><numeric name='cs::box' data='50000 5 0.01 0.5 0.5'/></custom>";
  std::string old = fields + kScene;
  old.insert(old.find("</worldbody>"),
             "<body pos='.1 0 .01'><freejoint/><geom name='box' type='box' size='.01 .01 .01'/></body>");
  EXPECT_TRUE(has(complaint(old, {"", layout(), {}, "b"}), "has fields \"cs::\""))
      << complaint(old, {"", layout(), {}, "b"});
  const fs::path scene = write(kScene);
  EXPECT_TRUE(has(test::complaint_of([&] {
                    static_cast<void>(patch(scene, {"", layout(), {}, "b"}, scene));
                  }),
                  "is a file of the scene itself"));
  const CompiledScene loaded = load_scene(scene, {{"", layout(), {}, "b"}});
  write("<worldbody><geom size='1'/></worldbody>");
  EXPECT_TRUE(has(test::complaint_of([&] {
                    static_cast<void>(patched_scene(scene, {{"", layout(), {}, "b"}}, loaded, s.folder / "saved.xml"));
                  }),
                  "has changed on disk since it was loaded"));
  EXPECT_FALSE(fs::exists(s.folder / "saved.xml"));
}

TEST_F(ScenePatch, PrintsTheWholeSceneIfNoPatchDescribesIt) {
  std::string copies = kScene;
  copies.insert(copies.find("<body"), "<replicate count='2' offset='1 0 0'>");
  copies.insert(copies.find("</worldbody>"), "</replicate>");
  const auto running = Simulator::load(write(copies), {{"geom 1", layout()}});
  const std::string note = save_scene(*running, s.folder / "saved.xml");
  EXPECT_TRUE(has(note, "a new print of the whole scene") && has(note, "made by <replicate>")) << note;
  EXPECT_TRUE(fs::is_directory(s.folder / "saved_files"));
  Simulator::load(s.folder / "saved.xml")->step();
}

}  // namespace
}  // namespace taxel
