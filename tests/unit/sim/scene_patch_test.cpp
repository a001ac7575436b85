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
