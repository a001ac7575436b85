// Scenes of users: with their own sensors, with an attached layout, invalid ones, and moved to another folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/model/geometry.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr const char* kBall = R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1'/>
      <body name='b' pos='0 0 0.0195'><freejoint/><geom name='ball' type='mesh' mesh='ball'/></body>
      <body pos='0.2 0 0.01'><freejoint/><geom name='box' type='box' size='.01 .01 .01'/></body></worldbody>)";

class LoadScene : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }
  std::filesystem::path write(const std::string& xml) {
    write_file_atomically(s.folder / "scene.xml", "<mujoco>" + xml + "</mujoco>");
    return s.folder / "scene.xml";
  }
  std::string layout() const { return (s.folder / "ball.taxels.json").string(); }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
  SensorScene s;
};

TEST_F(LoadScene, LoadsItsOwnSensors) {
  const auto simulator = Simulator::load(write(sensor_extension("ball", key("others", "floor")) + kBall));
  ASSERT_EQ(simulator->scene()->sensors.size(), 1u);
  EXPECT_EQ(simulator->scene()->sensor_geoms[0], "ball");
  EXPECT_EQ(simulator->scene()->geoms.size(), 3u);
  EXPECT_TRUE(simulator->scene()->geoms[0].plane);
  EXPECT_EQ(simulator->scene()->duration, 0);
  for (int n = 0; n < 100; ++n) simulator->step();
  EXPECT_TRUE(simulator->row_due());
  EXPECT_FALSE(simulator->finished());
  EXPECT_GT(row_of(simulator->view()).sensors[0].readings[0], 0);
}

TEST_F(LoadScene, ReplacesMujocosContactByAnAttachedLayout) {
  const std::filesystem::path scene = write(kBall);
  const auto simulator = Simulator::load(scene, {{"ball", layout()}});
  for (int n = 0; n < 1000; ++n) simulator->step();
  const RecordedRow row = row_of(simulator->view());
  // The mesh of this icosphere at MuJoCo's default density.
  const double weight = 9.81 * 1000 * make_sphere(0.02, 0.008).volume();
  EXPECT_NEAR(row.sensors[0].force_W.z, weight, 0.01 * weight);
  EXPECT_TRUE(simulator->warnings().empty()) << simulator->warnings()[0];
}

/// Returns a scene like kBall, whose sensor geom is only drawn, with another geom on its body.
std::string visual_ball(const std::string& sister) {
  std::string scene = kBall;
  const std::string geom = "<geom name='ball' type='mesh' mesh='ball'/>";
  scene.replace(scene.find(geom), geom.size(),
                "<geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/>" + sister);
  return scene;
}

TEST_F(LoadScene, CarriesTheBodyOnADrawnSkinInsteadOfItsCollisionGeom) {
  const std::filesystem::path scene = write(visual_ball("<geom name='core' type='sphere' size='.0199'/>"));
  const double weight = 2 * 9.81 * 1000 * make_sphere(0.02, 0.008).volume();  // of both geoms, nearly
  const auto force_of = [&](bool keeps) {
    const auto simulator = Simulator::load(scene, {{"ball", layout(), {}, "", "", keeps}});
    for (int n = 0; n < 1500; ++n) simulator->step();
    const bool is_warned = !simulator->warnings().empty() && has(simulator->warnings().back(), "\"core\" carries");
    EXPECT_EQ(is_warned, keeps);
    return row_of(simulator->view()).sensors[0].force_W.z;
  };
  EXPECT_NEAR(force_of(false), weight, 0.02 * weight);
  EXPECT_LT(force_of(true), 0.5 * weight);
}

TEST_F(LoadScene, NamesTheGeomsWhoseContactsTheSkinReplaces) {
  register_sensor_plugin();
  const CompiledScene inside =
      load_scene(write(visual_ball("<geom name='core' type='sphere' size='.0199'/>")), {{"ball", layout()}});
  EXPECT_TRUE(std::ranges::any_of(inside.notes, [](const std::string& note) {
    return note == "the skin on \"ball\" replaces the contacts of what lies within it: \"core\" (100 % of its surface)";
  }));
  const mjModel& m = *inside.model;
  EXPECT_EQ(m.geom_contype[mj_name2id(&m, mjOBJ_GEOM, "core")], 0);
  // A rod, of which two thirds are in the skin, is replaced; one of which a third is in it remains.
  for (const auto& [z, type] : {std::pair(0.01, 0), {0.03, 1}}) {
    const CompiledScene rod = load_scene(
        write(visual_ball(fmt::format("<geom name='rod' type='cylinder' size='.002 .02' pos='0 0 {}'/>", z))),
        {{"ball", layout()}});
    EXPECT_EQ(rod.model->geom_contype[mj_name2id(rod.model.get(), mjOBJ_GEOM, "rod")], type) << z;
  }
  const std::string leg = "<geom name='leg' type='sphere' size='.005' pos='.03 0 -.0145'/>";
  const CompiledScene outside = load_scene(write(visual_ball(leg)), {{"ball", layout()}});
  EXPECT_TRUE(outside.notes.empty());
  EXPECT_EQ(outside.model->geom_contype[mj_name2id(outside.model.get(), mjOBJ_GEOM, "leg")], 1);
}

TEST_F(LoadScene, TouchesOnlyTheNamedGeomsAndFindsTheMeshOfABody) {
  const std::filesystem::path scene = write(visual_ball("<geom name='core' type='sphere' size='.0199'/>"));
  const auto simulator = Simulator::load(scene, {{"", layout(), {}, "b", "floor", false}});
  EXPECT_EQ(simulator->scene()->sensor_geoms[0], "ball");
  ASSERT_EQ(simulator->scene()->touched[0].size(), 1U);
  EXPECT_EQ(simulator->scene()->touched[0][0].name, "floor");
  const auto complaint = [&](const std::string& body) {
    return test::complaint_of([&] { Simulator::load(scene, {{"", layout(), {}, body, "", false}}); });
  };
  EXPECT_TRUE(has(complaint("c"), "has no body \"c\""));
  EXPECT_TRUE(has(complaint("world"), "body \"world\" has no geom with a mesh"));
}

TEST_F(LoadScene, LoadsAUrdf) {
  write_file_atomically(s.folder / "robot.urdf", R"(<robot name="r"><link name="base"/><link name="tip"><inertial>
      <mass value=".1"/><inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial><collision name="skin">
      <geometry><mesh filename="package://r/meshes/ball.obj"/></geometry></collision></link>
      <joint name="j" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
      <limit lower="-.1" upper=".1" effort="1" velocity="1"/></joint><link name="cap"><collision><geometry>
      <sphere radius=".01"/></geometry></collision></link><joint name="f" type="fixed"><parent link="base"/>
      <child link="cap"/><origin xyz="0 0 0.029"/></joint></robot>)");
  const auto simulator = Simulator::load(s.folder / "robot.urdf", {{"skin", layout()}});
  simulator->step();
  EXPECT_GT(glm::length(row_of(simulator->view()).sensors[0].force_W), 0.01) << "the cap is 1 mm in the skin";
  write_file_atomically(s.folder / "bad.urdf", "<robot name='r'><link/></robot>");
  EXPECT_TRUE(has(test::complaint_of([&] { Simulator::load(s.folder / "bad.urdf", {}); }), "bad.urdf"));
}

TEST_F(LoadScene, ExcludesNoOtherContact) {
  // A second geom on the sensor's body touches the floor by MuJoCo's contact, which must stay. The contacts of the
  // sensor's own geom go with its bits.
  std::string scene = kBall;
  scene.replace(scene.find("mesh='ball'/>"), 13,
                "mesh='ball'/><geom name='leg' type='sphere' size='.005' pos='.03 0 -.0145'/>");
  register_sensor_plugin();
  const CompiledScene compiled = load_scene(write(scene), {{"ball", layout()}});
  const DataHandle data(mj_makeData(compiled.model.get()));
  mj_step(compiled.model.get(), data.get());
  bool leg_touches = false, ball_touches = false;
  for (int c = 0; c < data->ncon; ++c) {
    const std::string a = geom_name(*compiled.model, data->contact[c].geom[0]);
    const std::string b = geom_name(*compiled.model, data->contact[c].geom[1]);
    leg_touches |= (a == "floor" && b == "leg") || (a == "leg" && b == "floor");
    ball_touches |= a == "ball" || b == "ball";
  }
  EXPECT_TRUE(leg_touches);
  EXPECT_FALSE(ball_touches);
  const auto sensor = Simulator::load(s.folder / "scene.xml", {{"ball", layout()}});
  sensor->step();
  EXPECT_GT(row_of(sensor->view()).sensors[0].force_W.z, 0);
  ASSERT_EQ(sensor->scene()->touched[0].size(), 2U) << "the floor and the box";
  EXPECT_EQ(compiled.model->nexclude, 0);  // nor ball and box: the leg may touch the box
}

TEST_F(LoadScene, FindsItsFilesFromAnyFolder) {
  std::filesystem::create_directory(s.folder / "meshes");
  std::filesystem::rename(s.folder / "ball.obj", s.folder / "meshes/ball.obj");
  save_mesh(s.folder / "ball.obj", make_sphere(0.02, 0.008));  // for the layout
  const std::filesystem::path scene = write("<compiler meshdir='meshes'/>" + std::string(kBall));
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(s.folder.parent_path());
  const std::string error = test::complaint_of([&] {
    Simulator::load(s.folder.filename() / "scene.xml", {{"ball", layout()}});
  });
  std::filesystem::current_path(before);
  EXPECT_EQ(error, "accepted");
}

TEST_F(LoadScene, RepeatsAMovedCopyBitForBit) {
  const auto original = Simulator::load(write(sensor_extension("ball", key("others", "floor")) + kBall));
  export_scene(*original, s.folder / "copy");
  for (const char* name : {"ball.obj", "ball.taxels.json", "scene.xml"}) std::filesystem::remove(s.folder / name);
  std::filesystem::rename(s.folder / "copy", s.folder / "moved");
  const auto copy = Simulator::load(s.folder / "moved/scene.xml");
  double largest = 0;
  for (int n = 0; n < 200; ++n) {
    original->step();
    copy->step();
    const RecordedRow expected = row_of(original->view()), row = row_of(copy->view());
    ASSERT_EQ(row.sensors.size(), expected.sensors.size());
    for (std::size_t i = 0; i < row.sensors.size(); ++i)
      ASSERT_EQ(row.sensors[i].readings, expected.sensors[i].readings) << n;
    largest = std::max(largest, row.sensors[0].readings[0]);
  }
  EXPECT_GT(largest, 0);
}

TEST_F(LoadScene, RunsAMovedCopyOfAnAttachedLayout) {
  const auto original = Simulator::load(write(kBall), {{"ball", layout()}});
  export_scene(*original, s.folder / "copy");
  const auto copy = Simulator::load(s.folder / "copy/scene.xml");
  for (int n = 0; n < 200; ++n) {
    original->step();
    copy->step();
  }
  EXPECT_NEAR(row_of(copy->view()).sensors[0].force_W.z, row_of(original->view()).sensors[0].force_W.z, 1e-6);
  EXPECT_TRUE(copy->warnings().empty());
}

TEST_F(LoadScene, NamesTheFileAndTheReasonOfAMistake) {
  const std::string scene = (s.folder / "scene.xml").string();
  EXPECT_EQ(test::complaint_of([&] { Simulator::load(s.folder / "none.xml"); }),
            (s.folder / "none.xml").string() + ": no such file");
  write("<worldbody><geom type='globe'/></worldbody>");
  std::string error = test::complaint_of([&] { Simulator::load(scene); });
  EXPECT_TRUE(error.starts_with(scene + ": ")) << error;
  EXPECT_TRUE(has(error, "globe") || has(error, "type")) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
  write(kBall);
  error = test::complaint_of([&] { Simulator::load(scene, {{"bull", layout()}}); });
  EXPECT_TRUE(error.starts_with(scene + ": ")) << error;
  EXPECT_TRUE(has(error, "geom") && has(error, "\"bull\"")) << error;
  error = test::complaint_of([&] { Simulator::load(scene, {{"ball", (s.folder / "nothing.json").string()}}); });
  EXPECT_TRUE(has(error, "nothing.json")) << error;
  error = test::complaint_of([&] { Simulator::load(scene, {{"", layout()}}); });
  EXPECT_TRUE(has(error, "go together")) << error;
}

TEST_F(LoadScene, StopsAnUnstableSceneAndNamesItsTime) {
  const auto simulator = Simulator::load(
      write("<worldbody><body><joint type='slide' stiffness='-1e7'/><geom size='.1'/></body></worldbody>"
            "<keyframe><key qpos='0'/></keyframe>"));
  const std::string error = test::complaint_of([&] {
    for (int n = 0; n < 2000; ++n) simulator->step();
  });
  EXPECT_TRUE(has(error, "unstable at")) << error;
}

}  // namespace
}  // namespace taxel
