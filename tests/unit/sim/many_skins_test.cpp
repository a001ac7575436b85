// Hands of many skins: compiled and computed side by side with the same bits, without a contact lost by bounding boxes.
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/parallel.h"
#include "core/base/random_pose.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/pairs/geom_body.h"
#include "core/sim/simulator.h"
#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

constexpr const char* kTwoBoxes = R"(<mujoco><option gravity="0 0 0"/>
  <extension><plugin plugin="taxel.contact"><instance name="both">
    <config key="materials" value='{"a": {"modulus": 50000}, "b": {"modulus": 50000}}'/>
    <config key="pairs" value="a b"/><config key="output" value="area"/></instance></plugin></extension>
  <default><geom contype="0" conaffinity="0"/></default>
  <worldbody><geom name="a" type="box" size="0.05 0.01 0.008" pos="0.1 0 0" euler="10 20 30"/>
    <body><freejoint/><geom name="b" type="box" size="0.04 0.012 0.006" mass="1"/></body></worldbody>
  <sensor><plugin name="areas" plugin="taxel.contact" instance="both"/></sensor></mujoco>)";

TEST(ManySkins, LeaveOutPairsWhoseBoxesAreApartAndNoContact) {
  SensorScene scene;
  scene.compile(kTwoBoxes);
  ASSERT_NE(scene.model, nullptr) << scene.error;
  const mjModel& m = *scene.model;
  mjData& d = *scene.data;
  const OtherMaterials materials = parse_materials(R"({"a": {"modulus": 50000}, "b": {"modulus": 50000}})", "test");
  std::string repair;
  const HydroBodyPtr a = geom_body(m, 0, materials, repair), b = geom_body(m, 1, materials, repair);
  const double reach = glm::length(dvec3(0.05, 0.01, 0.008)) + glm::length(dvec3(0.04, 0.012, 0.006));
  IntersectWorkspace workspace;
  ContactSurface surface;
  int in_reach = 0, near = 0, touching = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pose X = random_pose(3, i, 0.05);
    const double qpos[] = {X.p.x + 0.1, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z};
    std::copy(std::begin(qpos), std::end(qpos), d.qpos);
    mj_forward(&m, &d);
    intersect(*a, *b, geom_pose(m, d, 0), geom_pose(m, d, 1), surface, workspace);
    const double area = surface.area();
    ASSERT_EQ(d.sensordata[0], area) << i;
    ASSERT_NEAR(d.sensordata[1], area, 1e-12) << i;
    in_reach += glm::length(X.p) < reach ? 1 : 0;
    near += find_body(d, {0, 0})->latest().near.empty() ? 0 : 1;
    touching += area > 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 300);
  EXPECT_GE(near, touching);
  EXPECT_LT(near, 1.1 * touching) << "boxes of boxes are tight";
  EXPECT_GT(in_reach, 2 * near) << "spheres alone would find many more";
}

/// The state and the readings after some steps of a hand of five fingers, which holds a ball.
std::vector<double> run_hand() {
  const std::string file = std::string(TAXEL_SOURCE_DIR) + "/assets/scenes/hand_grasps_ball.xml";
  const auto hand = Simulator::load(file);
  for (int n = 0; n < 150; ++n) hand->step();
  std::vector<double> values;
  std::size_t polygons = 0;
  for (const SensorView& sensor : hand->view().sensors) {
    for (const ContactSurface* surface : sensor.surfaces) polygons += surface->polygons.size();
    values.insert(values.end(), sensor.readings.begin(), sensor.readings.end());
  }
  SimState state;
  hand->save_state(state);
  values.insert(values.end(), state.integration.begin(), state.integration.end());
  EXPECT_GT(polygons, 500U) << "too few to be computed side by side";
  return values;
}

TEST(ManySkins, HaveTheSameBitsSideBySideAndOneAfterAnother) {
  const std::vector<double> side_by_side = run_hand();
  std::vector<double> alone;
  on_this_core([&] { alone = run_hand(); });
  ASSERT_EQ(side_by_side.size(), alone.size());
  EXPECT_EQ(0, std::memcmp(side_by_side.data(), alone.data(), alone.size() * sizeof(double)));
}

/// A scene of three sensors on cubes above a floor.
std::string three_cubes(const std::string& layout_of_last) {
  std::string instances, bodies, sensors, meshes;
  for (const std::string name : {"first", "second", "third"}) {
    const std::string layout = name == "third" ? layout_of_last : name + ".taxels.json";
    instances += "<instance name=\"" + name + "\">" + key("layout", layout) + key("geom", name) +
                 key("others", "floor") + "</instance>";
    meshes += "<mesh name=\"" + name + "\" file=\"" + name + ".obj\"/>";
    bodies += "<body pos=\"0 0 1\"><freejoint/><geom name=\"" + name + "\" type=\"mesh\" mesh=\"" + name +
              "\" contype=\"0\" conaffinity=\"0\"/></body>";
    sensors += "<plugin name=\"" + name + "\" plugin=\"taxel.sensor\" instance=\"" + name + "\"/>";
  }
  return "<mujoco><extension><plugin plugin=\"taxel.sensor\">" + instances + "</plugin></extension><asset>" + meshes +
         "</asset><worldbody><geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/>" + bodies + "</worldbody><sensor>" +
         sensors + "</sensor></mujoco>";
}

TEST(ManySkins, AreCompiledSideBySideForTheirInstances) {
  SensorScene scene;
  int half = 10;
  for (const char* name : {"first", "second", "third"})
    scene.add_sensor(name, make_box(dvec3(1e-3 * half++)), {.field = FieldKind::pad, .modulus = 5e4});
  scene.compile(three_cubes("third.taxels.json"));
  ASSERT_NE(scene.data, nullptr) << scene.error;
  {
    const CompiledSensors again = compile_side_by_side(*scene.model);
    ASSERT_EQ(again.models.size(), 3U);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(again.models[static_cast<std::size_t>(i)], scene.sensor(i).model()) << i;
  }
  const std::weak_ptr<const SensorModel> third = scene.sensor(2).model();
  const SensorModelPtr replacement = with_readout(*scene.sensor(2).model(), {});
  scene.step();
  scene.sensor(2).hand_over(*scene.model, replacement);
  EXPECT_TRUE(third.expired()) << "a model that was replaced is kept after the first step";
}

TEST(ManySkins, NameTheSensorWhoseLayoutIsMissing) {
  SensorScene scene;
  for (const char* name : {"first", "second", "third"})
    scene.add_sensor(name, make_box(dvec3(0.01)), {.field = FieldKind::pad, .modulus = 5e4});
  scene.compile(three_cubes("absent.taxels.json"));
  EXPECT_EQ(scene.model, nullptr);
  EXPECT_NE(scene.error.find("\"third\""), std::string::npos) << scene.error;
  EXPECT_NE(scene.error.find("absent.taxels.json"), std::string::npos) << scene.error;
}

}  // namespace
}  // namespace taxel::test
