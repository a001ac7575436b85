// Bodies moved by hydroelastic contact under MuJoCo's integrators, compared with closed forms (A1 and A9 of
// contact.md).
#include <gtest/gtest.h>

#include <functional>

#include "fixtures/bouncing_ball.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr double kGravity = 9.81;

Material pad(double modulus, double thickness, double dissipation) {
  return {FieldKind::pad, modulus, thickness, dissipation, 0.5};
}

class UnderIntegrator : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, UnderIntegrator, testing::Values("Euler", "RK4", "implicit", "implicitfast", "discrete"),
                         [](const auto& test) { return test.param; });

TEST_P(UnderIntegrator, BringsADroppedSoftBallToRestAtItsWeight) {
  const double R = 0.02, E = 5e4, mass = 0.05;
  SensorScene s;
  const TriMesh ball = scaled_to_volume(make_sphere(R, 0.005), 4.0 / 3 * kPi * R * R * R);
  s.add_sensor("ball", ball, {FieldKind::star, E, 0, 5.0, 0.5});
  s.compile("<mujoco><option timestep='0.002' integrator='" + std::string(GetParam()) + "'/>" +
            sensor_extension("ball", key("others", "floor")) +
            R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body pos='0 0 0.03'><freejoint/><inertial mass='0.05' pos='0 0 0' diaginertia='8e-6 8e-6 8e-6'/>
        <geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  double rebound = 0;
  for (int n = 0; n < 750; ++n) {
    s.step();
    if (n > 25) rebound = std::max(rebound, s.data->qvel[2]);  // after the first impact
  }
  const double x = R - s.data->qpos[2];
  EXPECT_LT(std::abs(s.data->qvel[2]), 1e-6);
  EXPECT_NEAR(kPi * E * x * x * (1 - 2 * x / (3 * R)), mass * kGravity, 0.02 * mass * kGravity);
  EXPECT_GT(rebound, 0.01);
  EXPECT_LE(rebound, 1 / 5.0);  // never faster than 1/d
}

/// A soft block on a rigid slope, started at its equilibrium depth. The slope is level and gravity is tilted.
struct Slope {
  SensorScene s;
  Slope(const std::string& integrator, double degrees, const std::function<void(Layout&)>& change = {}) {
    const double theta = degrees * kPi / 180, mass = 0.1, area = 0.06 * 0.06;
    // Approximately, because the rim yields more.
    const double depth = mass * kGravity * std::cos(theta) / (area * 2e4 / 0.005);
    s.add_sensor("block", make_box({0.03, 0.03, 0.015}), pad(2e4, 0.005, 20));
    if (change) {
      Layout layout = read_layout(s.folder / "block.taxels.json");
      change(layout);
      write_layout(s.folder / "block.taxels.json", layout);
    }
    s.compile("<mujoco><option timestep='0.002' integrator='" + integrator + "' gravity='" +
              std::to_string(kGravity * std::sin(theta)) + " 0 " + std::to_string(-kGravity * std::cos(theta)) + "'/>" +
              sensor_extension("block", key("others", "floor")) +
              R"(<asset><mesh name='block' file='block.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0' friction='0.5'/>
      <body pos='0 0 )" +
              std::to_string(0.015 - depth) +
              R"('><freejoint/><inertial mass='0.1' pos='0 0 -0.014' diaginertia='3.7e-5 3.7e-5 6e-5'/>
        <geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  }
};

TEST_P(UnderIntegrator, LetsABlockOnASlopeCreepWithoutChatter) {
  for (const double degrees : {5.0, 15.0, 20.0}) {
    Slope slope(GetParam(), degrees);
    ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
    slope.s.step(400);
    const double tan = std::tan(degrees * kPi / 180);
    const double creep = kSlipSpeed * std::tan(kPi * tan / (2 * 0.5));
    for (int n = 0; n < 50; ++n) {
      slope.s.step();
      EXPECT_NEAR(slope.s.data->qvel[0], creep, 0.01 * creep) << degrees << " degrees, step " << n;
    }
  }
}

// The only taxel reaches the whole contact, so its force and its shear are those of the wrench: mg cos and mg sin at
// rest.
TEST_P(UnderIntegrator, ReadsTheFrictionThatHoldsABlockAsShear) {
  const double degrees = 15, theta = degrees * kPi / 180, weight = 0.1 * kGravity;
  Slope slope(GetParam(), degrees, [](Layout& layout) {
    layout.readout.aggregate = Aggregate::force;
    layout.readout.shear = true;
    layout.receptive_field.max_angle_deg = 180;  // includes the block's sides
    layout.taxels[0].radius = 0.05;
  });
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  for (const int steps : {3, 400}) {  // while the block starts to slide, and at rest
    slope.s.step(steps);
    const HydroInstance& sensor = slope.s.sensor();
    const Wrench& wrench = sensor.sensed().pairs.at(0).wrench;
    ASSERT_EQ(sensor.reading().shear.size(), 1U);
    const dvec2 shear = sensor.reading().shear[0];  // e1 = y, e2 = -z x y = x
    EXPECT_LT(wrench.force.x, 0);
    EXPECT_NEAR(shear.y, wrench.force.x, 1e-4 * weight) << steps;
    EXPECT_NEAR(shear.x, wrench.force.y, 1e-4 * weight) << steps;
  }
  EXPECT_NEAR(slope.s.sensor().reading().values[0], weight * std::cos(theta), 2e-3 * weight);
  EXPECT_NEAR(slope.s.sensor().reading().shear[0].y, -weight * std::sin(theta), 2e-3 * weight);
}

TEST_P(UnderIntegrator, AcceleratesABlockOnASteepSlope) {
  const double theta = 35 * kPi / 180;
  Slope slope(GetParam(), 35);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  slope.s.step(200);
  const double before = slope.s.data->qvel[0];
  slope.s.step(200);
  const double acceleration = (slope.s.data->qvel[0] - before) / 0.4;
  const double exact = kGravity * (std::sin(theta) - 0.5 * std::cos(theta));
  EXPECT_NEAR(acceleration, exact, 0.01 * exact);
}

/// Returns the depth of a soft block at rest on a level floor with a material.
double depth_at_rest(const std::string& floor_material) {
  SensorScene s;
  s.add_sensor("block", make_box({0.03, 0.03, 0.015}), pad(2e4, 0.005, 20));
  s.compile("<mujoco>" + sensor_extension("block", key("others", "floor") + key("materials", floor_material)) +
            R"(<asset><mesh name='block' file='block.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body pos='0 0 0.0145'><freejoint/><inertial mass='0.1' pos='0 0 0' diaginertia='3.7e-5 3.7e-5 6e-5'/>
        <geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  if (s.model == nullptr) throw Error(s.error);
  s.step(1000);
  return 0.015 - s.data->qpos[2];
}

// A8: stiffnesses in series. The block is compressed as on a rigid floor, the floor kA/kB times as much.
TEST(ContactDynamics, TreatsASoftFloorAsASpringInSeries) {
  const double rigid = depth_at_rest("{}"), kA = 2e4 / 0.005, kB = 1e5 / 0.01;
  const double soft = depth_at_rest(R"({"floor": {"modulus": 1e5, "thickness": 0.01}})");
  EXPECT_NEAR(rigid, 0.1 * kGravity / (0.06 * 0.06 * kA), 0.03 * rigid);  // the rim yields more
  EXPECT_NEAR(soft, rigid * (1 + kA / kB), 1e-4 * rigid);
}

TEST(ContactDynamics, GivesAFreeBoxTheOppositeWrench) {
  // A heavy free box far from anything else, and a soft ball that moves into it and slides along it: momentum is
  // conserved.
  SensorScene s;
  s.add_sensor("ball", make_sphere(0.02, 0.006), {FieldKind::star, 5e4, 0, 5.0, 0.5});
  s.compile("<mujoco><option timestep='0.001' gravity='0 0 0'/>" +
            sensor_extension("ball", key("others", "box") + key("output", "readings wrench area")) +
            R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <body name='box'><freejoint/><geom name='box' type='box' size='.03 .03 .03' mass='0.3' contype='0' conaffinity='0'/></body>
      <body name='ball' pos='0.004 -0.003 0.0485'><freejoint/><inertial mass='.05' pos='0 0 0' diaginertia='8e-6 8e-6 8e-6'/>
        <geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const mjModel& m = *s.model;
  mjData& d = *s.data;
  d.qvel[6] = 0.05;
  d.qvel[8] = -0.1;
  d.qvel[10] = 3;
  const auto momentum = [&] {
    mj_subtreeVel(&m, &d);
    return std::pair(dvec3(0.3 * d.subtree_linvel[3] + 0.05 * d.subtree_linvel[6],
                           0.3 * d.subtree_linvel[4] + 0.05 * d.subtree_linvel[7],
                           0.3 * d.subtree_linvel[5] + 0.05 * d.subtree_linvel[8]),
                     dvec3(d.subtree_angmom[0], d.subtree_angmom[1], d.subtree_angmom[2]));
  };
  mj_forward(&m, &d);
  const auto [linear, angular] = momentum();
  double largest = 0;
  for (int n = 0; n < 100; ++n) {
    s.step();
    // The wrench on the box, about the same point, is the opposite of the wrench on the ball. Both are free bodies:
    // their generalized forces are force and torque about their own origin (the torque in the body's frame).
    const dvec3 on_ball(d.qfrc_passive[6], d.qfrc_passive[7], d.qfrc_passive[8]);
    const dvec3 on_box(d.qfrc_passive[0], d.qfrc_passive[1], d.qfrc_passive[2]);
    EXPECT_LE(glm::length(on_ball + on_box), 1e-12 * glm::length(on_ball));
    largest = std::max(largest, glm::length(on_ball));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(d.sensordata[1 + i], on_ball[i], 1e-12);
  }
  EXPECT_GT(largest, 0.1);
  mj_forward(&m, &d);
  const auto [linear_end, angular_end] = momentum();
  EXPECT_LE(glm::length(linear_end - linear), 1e-12 * glm::length(linear));
  EXPECT_LE(glm::length(angular_end - angular), 2e-3 * glm::length(angular));  // the integrator's own error
  EXPECT_GT(glm::length(dvec3(d.qvel[0], d.qvel[1], d.qvel[2])), 0.005);       // the box was pushed
}

// A ball that falls and slides: friction and damping act on it, and the elastic wrench is that of the pressure alone.
TEST_P(UnderIntegrator, WritesTheElasticWrenchWithoutFrictionAndDamping) {
  SensorScene s;
  s.add_sensor("ball", make_sphere(0.02, 0.006), {FieldKind::star, 5e4, 0, 5.0, 0.5});
  s.compile("<mujoco><option timestep='0.001' integrator='" + std::string(GetParam()) + "'/>" +
            sensor_extension("ball", key("others", "floor") + key("output", "elastic_wrench wrench")) +
            R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0' friction='0.5'/>
      <body pos='0 0 0.019'><freejoint/><inertial mass='0.05' pos='0 0 0' diaginertia='8e-6 8e-6 8e-6'/>
        <geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  ASSERT_EQ(s.model->nsensordata, 12);
  s.data->qvel[0] = 0.2;
  s.data->qvel[2] = -0.1;
  s.step();
  const mjtNum* out = s.data->sensordata;
  const Evaluation& e = s.sensor().sensed();
  const Wrench elastic = pressure_wrench(e.pairs.at(0).surface);
  const dvec3 force_W = e.X_WM.rotate(elastic.force), torque_W = e.X_WM.rotate(elastic.torque);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(out[i], force_W[i]);
    EXPECT_EQ(out[3 + i], torque_W[i]);
  }
  EXPECT_NEAR(out[0], 0, 1e-3 * out[2]);  // no friction
  EXPECT_LT(out[6], -0.4 * out[8]);       // with friction
  EXPECT_GT(out[8], 1.2 * out[2]);        // damping pushes as well
  const mjtNum before = out[2];           // of the state at the start, as after the reset
  mj_resetData(s.model.get(), s.data.get());
  s.data->qvel[2] = 0.3;  // departs
  mj_forward(s.model.get(), s.data.get());
  EXPECT_EQ(out[2], before);
  EXPECT_LT(out[8], 0.1 * out[2]);
}

/// Returns the wrench of the floor's contacts on the box: force, and torque about `origin`, in the world.
Wrench from_floor(const mjModel& m, const mjData& d, const dvec3& origin) {
  Wrench sum;
  for (int c = 0; c < d.ncon; ++c) {
    const mjContact& contact = d.contact[c];
    mjtNum local[6];
    mj_contactForce(&m, &d, c, local);
    dvec3 force(0);  // rows of the frame are its axes; the normal points from the first geom to the second
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) force[j] += local[i] * contact.frame[3 * i + j];
    const char* second = m.names + m.name_geomadr[contact.geom[1]];
    if (std::string(second) != "box") force = -force;
    sum.force += force;
    sum.torque += glm::cross(dvec3(contact.pos[0], contact.pos[1], contact.pos[2]) - origin, force);
  }
  return sum;
}

TEST(ContactDynamics, TransmitsTheWrenchThroughAFreeBoxToThePlane) {
  // A fixed soft ball presses off-centre on a free box that is on MuJoCo's own plane.
  const double mass = 0.05, away = 0.008;
  SensorScene s;
  s.add_sensor("ball", make_sphere(0.02, 0.006), {FieldKind::star, 5e4, 0, 20, 0.5});
  s.compile(
      "<mujoco>" + sensor_extension("ball", key("others", "box")) +
      R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1'/>
      <body name='box' pos='0 0 0.03'><freejoint/><geom name='box' type='box' size='.03 .03 .03' mass='0.05'/></body>
      <body pos=')" +
      std::to_string(away) +
      R"( 0 0.078'><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(1500);
  const mjData& d = *s.data;
  for (int i = 0; i < 6; ++i) ASSERT_LT(std::abs(d.qvel[i]), 1e-3) << "at rest";
  const Evaluation& e = s.sensor().sensed();
  const dvec3 center(d.qpos[0], d.qpos[1], d.qpos[2]);
  const dvec3 on_box = -e.X_WM.rotate(e.pairs[0].wrench.force);
  const dvec3 turning = -e.X_WM.rotate(e.pairs[0].wrench.torque) + glm::cross(e.X_WM.p - center, on_box);
  const Wrench floor = from_floor(*s.model, d, center);
  ASSERT_LT(on_box.z, -0.3);
  ASSERT_GT(turning.y, 0.3 * away);
  EXPECT_NEAR(floor.force.z, mass * kGravity - on_box.z, 0.02 * -on_box.z);
  EXPECT_LE(glm::length(floor.torque + turning), 0.02 * glm::length(turning));
}

TEST(ContactDynamics, SharesTheWeightOfABoxBetweenTwoFingers) {
  // Two sensors press a free box from both sides: the forces of each instance consider those of the other.
  SensorScene s;
  for (const char* name : {"left", "right"})
    s.add_sensor(name, make_sphere(0.02, 0.006), {FieldKind::star, 5e4, 0, 20, 0.5});
  const std::string extension =
      R"(<extension><plugin plugin="taxel.sensor"><instance name="left"><config key="layout" value="left.taxels.json"/>
      <config key="geom" value="left"/><config key="others" value="box"/></instance><instance name="right">
      <config key="layout" value="right.taxels.json"/><config key="geom" value="right"/><config key="others" value="box"/>
      </instance></plugin></extension><sensor><plugin name="l" plugin="taxel.sensor" instance="left"/>
      <plugin name="r" plugin="taxel.sensor" instance="right"/></sensor>)";
  s.compile("<mujoco><option timestep='0.001'/>" + extension +
            R"(<default><geom contype='0' conaffinity='0'/></default>
      <asset><mesh name='left' file='left.obj'/><mesh name='right' file='right.obj'/></asset><worldbody>
      <body name='box'><freejoint/><geom name='box' type='box' size='.03 .03 .03' mass='0.05' friction='0.5'/></body>
      <body pos='-0.048 0 0'><geom name='left' type='mesh' mesh='left'/></body>
      <body pos='0.048 0 0'><geom name='right' type='mesh' mesh='right'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(1500);
  const double weight = 0.05 * kGravity, x = 0.002;
  const double press = kPi * 5e4 * x * x * (1 - 2 * x / (3 * 0.02));
  for (int i = 0; i < 2; ++i) {
    const Evaluation& e = s.sensor(i).sensed();
    const dvec3 force = e.X_WM.rotate(e.pairs[0].wrench.force);
    EXPECT_NEAR(force.z, -0.5 * weight, 0.01 * weight);  // the fingers carry the box
    EXPECT_NEAR(std::abs(force.x), press, 0.1 * press);  // the ball is coarse
  }
  const double ratio = weight / (2 * 0.5 * std::abs(s.sensor(0).sensed().pairs[0].wrench.force.x));
  EXPECT_NEAR(s.data->qvel[2], -kSlipSpeed * std::tan(kPi / 2 * ratio), 0.02 * kSlipSpeed);
}

TEST(ContactDynamics, NeverGainsEnergyWithDissipation) {
  const test::Flights flights = test::throw_ball("Euler", "", 0);
  EXPECT_GE(flights.count, 3);
  EXPECT_LT(flights.least, 0.05 * kGravity * 0.045);
}

}  // namespace
}  // namespace taxel
