// The plugin `taxel.contact` together with sensors, in copies of data, and in sensordata.
#include <gtest/gtest.h>

#include "core/base/files.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sim/simulator.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

std::string contact(const std::string& keys, const std::string& name = "soft") {
  return "<extension><plugin plugin='taxel.contact'><instance name='" + name + "'>" + keys +
         "</instance></plugin></extension>";
}
std::string free_ball(const std::string& name, double z) {
  return "<body pos='0 0 " + std::to_string(z) + "'><freejoint/><geom name='" + name +
         "' type='sphere' size='.02' mass='.05' contype='0' conaffinity='0'/></body>";
}
std::string material(const std::string& name, double modulus) {
  return "\"" + name + "\": {\"modulus\": " + std::to_string(modulus) +
         ", \"dissipation\": 3, \"friction\": 0.4, \"resolution\": 0.004}";
}
const BodyContacts& body_of(const SensorScene& s, int instance, int number) {
  return *find_body(*s.data, {instance, number});
}

/// Returns a scene of two soft balls, one on the other, on a rigid floor.
std::string stack(const std::string& more = "") {
  return "<mujoco><option timestep='0.001'/>" +
         contact(key("materials", "{" + material("a", 1e5) + ", " + material("b", 2e5) + "}") +
                 key("pairs", "a floor, a b")) +
         more + "<worldbody><geom name='floor' type='plane' size='1 1 1'/>" + free_ball("a", 0.0198) +
         free_ball("b", 0.0596) + "</worldbody></mujoco>";
}

/// A simulation of these balls after some steps, with its frame at this time.
struct SimulatedStack {
  explicit SimulatedStack(int steps) {
    write_file_atomically(scene.folder / "scene.xml", stack());
    simulator = Simulator::load(scene.folder / "scene.xml");
    for (int n = 0; n < steps; ++n) simulator->step();
    test::fill_frame(*simulator, frame);
  }
  SensorScene scene;
  std::unique_ptr<Simulator> simulator;
  SimFrame frame;
};

TEST(ContactPlugin, ComputesASoftPairOnceForBothBodies) {
  SensorScene s;
  s.compile(stack("<sensor><plugin plugin='taxel.contact' instance='soft'/></sensor>"));
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.model->nsensordata, 12);  // a wrench for each soft geom
  s.step(5);
  const BodyContacts &a = body_of(s, 0, 0), &b = body_of(s, 0, 1);
  ASSERT_EQ(a.touched().size(), 2U);  // floor and b
  ASSERT_EQ(b.touched().size(), 1U);
  EXPECT_NE(a.touched()[1].role.mirrored, b.touched()[0].role.mirrored);
  const PairState &on_a = a.sensed().pairs[1], &on_b = b.sensed().pairs[0];
  EXPECT_EQ(on_a.surface.polygons.size(), on_b.surface.polygons.size());
  ASSERT_GT(on_a.surface.polygons.size(), 5U);
  EXPECT_NEAR(on_a.surface.area(), on_b.surface.area(), 1e-12);
  EXPECT_NEAR(on_a.wrench.force.z, -on_b.wrench.force.z, 1e-9);
  EXPECT_NEAR(s.data->sensordata[8], on_b.wrench.force.z, 1e-9);
  EXPECT_NEAR(s.data->sensordata[2], on_a.wrench.force.z + a.sensed().pairs[0].wrench.force.z, 1e-9);
  EXPECT_TRUE(a.warnings.empty() && b.warnings.empty());
}

/// The recorded forces are the applied forces: only gravity and the recorded forces change each ball's momentum.
TEST(ContactPlugin, AppliesEachForceOnce) {
  SensorScene s;
  s.compile(stack());
  ASSERT_NE(s.model, nullptr) << s.error;
  for (int n = 0; n < 50; ++n) {
    const double before[2] = {s.data->qvel[2], s.data->qvel[8]};
    s.step();
    for (int ball = 0; ball < 2; ++ball) {
      double force = -0.05 * 9.81;
      for (const PairState& pair : body_of(s, 0, ball).sensed().pairs) force += pair.wrench.force.z;
      EXPECT_NEAR(0.05 * (s.data->qvel[6 * ball + 2] - before[ball]), 1e-3 * force, 1e-9) << n;
    }
  }
}

TEST(ContactPlugin, ContinuesAlikeInACopy) {
  SensorScene s;
  s.compile(stack());
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(20);
  const DataHandle copy(mj_copyData(nullptr, s.model.get(), s.data.get()));
  ASSERT_NE(find_body(*copy, {0, 1}), find_body(*s.data, {0, 1}));
  s.step(30);
  for (int i = 0; i < 30; ++i) mj_step(s.model.get(), copy.get());
  for (int i = 0; i < s.model->nq; ++i) EXPECT_EQ(s.data->qpos[i], copy->qpos[i]) << i;
}

TEST(ContactPlugin, StoresItsWholeStateForTheNextStep) {
  SensorScene s;
  s.compile(stack());
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(20);
  std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(s.model.get(), mjSTATE_INTEGRATION)));
  mj_getState(s.model.get(), s.data.get(), state.data(), mjSTATE_INTEGRATION);
  s.step(30);
  const std::vector<mjtNum> first(s.data->qpos, s.data->qpos + s.model->nq);
  mj_setState(s.model.get(), s.data.get(), state.data(), mjSTATE_INTEGRATION);
  s.step(30);
  EXPECT_EQ(std::vector<mjtNum>(s.data->qpos, s.data->qpos + s.model->nq), first);
}

/// A sensor on a mesh ball at z = 0, which presses on a plane and on a soft sphere.
class ContactNextToSensor : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("tip", make_sphere(0.02, 0.006), {FieldKind::star, 1e5, 0, 3, 0.4}); }
  std::string scene(const std::string& sensor_keys, const std::string& contacts) {
    return "<mujoco><option timestep='0.001' gravity='0 0 0'/>" + sensor_extension("tip", sensor_keys) + contacts +
           "<asset><mesh name='tip' file='tip.obj'/></asset><worldbody><geom name='wall' type='plane' size='1 1 1' "
           "pos='0 0 -.019'/><body><freejoint/><geom name='tip' type='mesh' mesh='tip' contype='0' conaffinity='0'/>"
           "</body>" +
           free_ball("ball", 0.0395) + "</worldbody></mujoco>";
  }
  SensorScene s;
};

TEST_F(ContactNextToSensor, SensesASoftGeomAndComputesThePairOnce) {
  s.compile(scene(key("others", "wall ball"),
                  contact(key("materials", "{" + material("ball", 1e5) + "}") + key("pairs", "ball wall"))));
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step();
  const int contact_instance = contact_instances(*s.model).at(0), sensor_instance = sensor_instances(*s.model).at(0);
  const BodyContacts& ball = body_of(s, contact_instance, 0);
  ASSERT_EQ(ball.touched().size(), 2U);  // the wall by name, the sensor because it touches the ball
  const HydroInstance& tip = s.sensor(sensor_instance);
  ASSERT_EQ(tip.touched().size(), 2U);
  const PairState &on_tip = tip.sensed().pairs[1], &on_ball = ball.sensed().pairs[1];
  ASSERT_GT(on_tip.surface.polygons.size(), 5U);
  EXPECT_NEAR(on_tip.wrench.force.z, -on_ball.wrench.force.z, 1e-9);
  EXPECT_DOUBLE_EQ(tip.touched()[1].properties.friction, 0.4);  // the ball's material is the contact's
  EXPECT_NE(tip.touched()[1].role.mirrored, ball.touched()[1].role.mirrored);
}

TEST_F(ContactNextToSensor, IncludesThePairsOfAContactWithItsGeom) {
  s.compile(scene(key("others", "wall"),
                  contact(key("materials", "{" + material("ball", 1e5) + "}") + key("pairs", "ball tip"))));
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step();
  EXPECT_EQ(s.sensor(sensor_instances(*s.model).at(0)).touched().size(), 2U);
  EXPECT_EQ(body_of(s, contact_instances(*s.model).at(0), 0).touched().size(), 1U);
}

TEST_F(ContactNextToSensor, RefusesContradictoryKeysByACompileError) {
  const auto error_of = [&](const std::string& sensor_keys, const std::string& contacts) {
    s.model.reset();
    s.compile(scene(sensor_keys, contacts));
    EXPECT_EQ(s.model, nullptr);
    return s.error;
  };
  const std::string soft = key("materials", "{" + material("ball", 1e5) + "}");
  EXPECT_NE(error_of(key("others", "wall") + key("force", "sense"), contact(soft + key("pairs", "ball tip")))
                .find("both must apply its force, or both sense it"),
            std::string::npos)
      << s.error;
  EXPECT_NE(error_of(key("materials", "{" + material("ball", 2e5) + "}"), contact(soft))
                .find("geom \"ball\" has two materials, of sensor \"tip\" and contact \"soft\""),
            std::string::npos)
      << s.error;
}

TEST(ContactPlugin, StoresItsSurfacesInSavedSteps) {
  const SimulatedStack s(5);
  const SimFrame& frame = s.frame;
  ASSERT_EQ(frame.sensors.size(), 2U);
  ASSERT_EQ(frame.sensors[0].surfaces.size(), 2U);
  EXPECT_TRUE(frame.sensors[0].readings.empty());
  write_file_atomically(s.scene.folder / "step.taxelframe", frame_to_bundle(frame, {}));
  const SimFramePtr read = read_frame_bundle(s.scene.folder / "step.taxelframe", {});
  ASSERT_EQ(read->sensors.size(), 2U);
  EXPECT_EQ(read->sensors[0].force_W, frame.sensors[0].force_W);
  EXPECT_EQ(read->sensors[1].surfaces[0].polygons.size(), frame.sensors[1].surfaces[0].polygons.size());
  EXPECT_EQ(read->scene->sensors[0]->body->material, frame.scene->sensors[0]->body->material);
  EXPECT_TRUE(read->scene->sensors[0]->body->soft());
}

/// The contact at recorded poses equals the contact in the step, for commands that compute a recording's contacts
/// again.
TEST(ContactPlugin, GivesTheContactOfTheStepAtItsPoses) {
  const SimulatedStack s(3);
  const SimFrame& frame = s.frame;
  const std::vector<Pose> poses{frame.sensors[0].X_WM, frame.sensors[1].X_WM};
  const SensorStep posed = s.simulator->contact_at(1, poses, frame.geom_poses);
  ASSERT_EQ(posed.surfaces.size(), 1U);
  EXPECT_EQ(posed.surfaces[0].polygons.size(), frame.sensors[1].surfaces[0].polygons.size());
  EXPECT_EQ(posed.surfaces[0].area(), frame.sensors[1].surfaces[0].area());
}

}  // namespace
}  // namespace taxel::test
