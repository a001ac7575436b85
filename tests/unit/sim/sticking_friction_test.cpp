// Friction that sticks, in MuJoCo: blocks on slopes under each integrator, restored states, and a grip of five fingers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/plugin/pairs/declared_bodies.h"
#include "fixtures/bouncing_ball.h"
#include "fixtures/recorded_simulation.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr double kGravity = 9.81;

class StickingUnder : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, StickingUnder, testing::Values("Euler", "RK4", "implicit", "implicitfast"),
                         [](const auto& test) { return test.param; });

/// A soft block with bristles on a rigid slope. The slope is level and gravity is tilted.
struct StickingSlope {
  SensorScene s;
  StickingSlope(const std::string& integrator, double theta, bool shear = false,
                Aggregate aggregate = Aggregate::force) {
    const double mass = 0.1, area = 0.06 * 0.06;
    const double depth = mass * kGravity * std::cos(theta) / (area * 2e4 / 0.005);
    s.add_sensor("block", make_box({0.03, 0.03, 0.015}), {FieldKind::pad, 2e4, 0.005, 20, 0.5});
    Layout layout = read_layout(s.folder / "block.taxels.json");  // one taxel that reaches the whole contact
    layout.readout.aggregate = aggregate;
    layout.readout.shear = shear;
    layout.receptive_field.max_angle_deg = 180;
    layout.taxels[0].radius = 0.05;
    write_layout(s.folder / "block.taxels.json", layout);
    s.compile("<mujoco><option timestep='0.002' integrator='" + integrator + "' gravity='" +
              std::to_string(kGravity * std::sin(theta)) + " 0 " + std::to_string(-kGravity * std::cos(theta)) + "'/>" +
              sensor_extension("block", key("others", "floor") + key("tangential_stiffness", "1e7") +
                                            key("bristles", "500") + key("output", "readings wrench area slip")) +
              R"(<asset><mesh name='block' file='block.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0' friction='0.5'/>
      <body pos='0 0 )" +
              std::to_string(0.015 - depth) +
              R"('><freejoint/><inertial mass='0.1' pos='0 0 -0.014' diaginertia='3.7e-5 3.7e-5 6e-5'/>
        <geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
  }
  [[nodiscard]] dvec3 place() const { return {s.data->qpos[0], s.data->qpos[1], s.data->qpos[2]}; }
};

TEST_P(StickingUnder, KeepsABlockOnASlopeInPlace) {
  StickingSlope slope(GetParam(), 15 * kPi / 180);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  slope.s.step(1500);  // comes to rest
  const dvec3 start = slope.place();
  double farthest = 0;
  for (int n = 0; n < 5000; ++n) {
    slope.s.step();
    farthest = std::max(farthest, glm::length(slope.place() - start));
  }
  EXPECT_LE(farthest, 1e-9);
  EXPECT_NEAR(slope.s.data->sensordata[1], -0.1 * kGravity * std::sin(15 * kPi / 180), 1e-6);
}

TEST_P(StickingUnder, LetsABlockSlipAtTheAngleOfFriction) {
  for (const double part : {0.995, 1.005}) {
    StickingSlope slope(GetParam(), std::atan(0.5 * part));
    ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
    slope.s.step(1500);
    const double before = slope.s.data->qvel[0];
    slope.s.step(500);
    if (part < 1) {
      EXPECT_LT(std::abs(slope.s.data->qvel[0]), 1e-9);
    } else {
      EXPECT_GT(slope.s.data->qvel[0], before + 0.01);
    }
  }
}

using StateBytes = std::vector<mjtNum>;

StateBytes state_of_scene(const SensorScene& s) {
  StateBytes state(static_cast<std::size_t>(mj_stateSize(s.model.get(), mjSTATE_INTEGRATION)));
  mj_getState(s.model.get(), s.data.get(), state.data(), mjSTATE_INTEGRATION);
  return state;
}

// A block that is pushed about while a part of its bristles slips.
TEST_P(StickingUnder, RepeatsRandomlyRestoredStatesBitForBit) {
  StickingSlope slope(GetParam(), 20 * kPi / 180);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  std::vector<StateBytes> states;
  std::vector<std::vector<mjtNum>> sensed;
  CounterRng random(7);
  constexpr std::uint64_t kSteps = 100;
  for (std::uint64_t n = 0; n < kSteps; ++n) {
    for (std::uint64_t i = 0; i < 6; ++i)
      slope.s.data->qfrc_applied[i] = (i < 3 ? 0.5 : 0.002) * (random.uniform(6 * n + i) - 0.5);
    states.push_back(state_of_scene(slope.s));
    slope.s.step();
    sensed.emplace_back(slope.s.data->sensordata, slope.s.data->sensordata + slope.s.model->nsensordata);
  }
  states.push_back(state_of_scene(slope.s));
  ASSERT_NE(states[50], states[51]);
  for (std::uint64_t trial = 0; trial < 1000; ++trial) {
    const auto n = static_cast<std::size_t>(random.bits(10000 + trial) % kSteps);
    mj_setState(slope.s.model.get(), slope.s.data.get(), states[n].data(), mjSTATE_INTEGRATION);
    if (trial % 10 == 0) slope.s.data.reset(mj_copyData(nullptr, slope.s.model.get(), slope.s.data.get()));
    slope.s.step();
    const std::vector<mjtNum> now(slope.s.data->sensordata, slope.s.data->sensordata + slope.s.model->nsensordata);
    ASSERT_EQ(now, sensed[n]) << "trial " << trial << ", step " << n;
    StateBytes after = state_of_scene(slope.s), recorded = states[n + 1];
    // The recorded state has the applied forces of the next step.
    mj_setState(slope.s.model.get(), slope.s.data.get(), recorded.data(), mjSTATE_INTEGRATION);
    const int size = mj_stateSize(slope.s.model.get(), mjSTATE_FULLPHYSICS);
    StateBytes expected(static_cast<std::size_t>(size)), got(static_cast<std::size_t>(size));
    mj_getState(slope.s.model.get(), slope.s.data.get(), expected.data(), mjSTATE_FULLPHYSICS);
    mj_setState(slope.s.model.get(), slope.s.data.get(), after.data(), mjSTATE_INTEGRATION);
    mj_getState(slope.s.model.get(), slope.s.data.get(), got.data(), mjSTATE_FULLPHYSICS);
    ASSERT_EQ(got, expected) << "trial " << trial << ", step " << n;
  }
}

TEST_P(StickingUnder, NeverGainsEnergy) {
  EXPECT_GE(test::throw_ball(GetParam(), key("tangential_stiffness", "1e7"), -20).count, 3);
}

// Five soft fingertips on slides press an object of 60 g between them.
TEST_P(StickingUnder, HoldsAnObjectInAGripOfFiveFingersWithoutCreep) {
  SensorScene s;
  std::string bodies, materials, pairs, actuators;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * kPi * i / 5;
    const std::string name = "finger" + std::to_string(i);
    materials += (i > 0 ? ", \"" : "\"") + name + R"(": {"modulus": 1e5, "dissipation": 5, "friction": 0.8})";
    pairs += (i > 0 ? ", " : "") + name + " can";
    bodies += "<body pos='" + std::to_string(0.0347 * std::cos(angle)) + " " +
              std::to_string(0.0347 * std::sin(angle)) + " 0'><joint name='" + name +
              "' type='slide' damping='2' axis='" + std::to_string(-std::cos(angle)) + " " +
              std::to_string(-std::sin(angle)) + " 0'/><geom name='" + name +
              "' type='sphere' size='0.01' mass='0.02'/></body>";
    actuators += "<motor joint='" + name + "' ctrlrange='-2 2'/>";
  }
  s.compile(R"(<mujoco><option timestep='0.002' integrator=')" + std::string(GetParam()) +
            R"('/><default><geom contype='0' conaffinity='0'/></default><extension><plugin plugin='taxel.contact'>
      <instance name='grip'><config key='materials' value='{)" +
            materials + "}'/><config key='pairs' value='" + pairs +
            R"('/><config key='tangential_stiffness' value='2e8'/><config key='bristles' value='800'/></instance>
      </plugin></extension><worldbody><body name='can'><freejoint/>
      <geom name='can' type='cylinder' size='0.025 0.04' mass='0.06' friction='0.8'/></body>)" +
            bodies + "</worldbody><actuator>" + actuators + "</actuator></mujoco>");
  ASSERT_NE(s.model, nullptr) << s.error;
  for (int i = 0; i < 5; ++i) s.data->ctrl[i] = 1;
  s.step(1000);  // comes to rest
  const dvec3 start{s.data->qpos[0], s.data->qpos[1], s.data->qpos[2]};
  double farthest = 0;
  for (int n = 0; n < 5000; ++n) {
    s.step();
    farthest = std::max(farthest, glm::length(dvec3(s.data->qpos[0], s.data->qpos[1], s.data->qpos[2]) - start));
  }
  RecordProperty("farthest_in_metres", fmt::format("{:.3g}", farthest));
  EXPECT_GT(start.z, -0.002);
  EXPECT_LT(farthest, 1e-6);
}

TEST_P(StickingUnder, ReadsTheFrictionThatHoldsABlockAsShear) {
  const double theta = 15 * kPi / 180, weight = 0.1 * kGravity;
  StickingSlope slope(GetParam(), theta, true);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  for (const int steps : {3, 300}) {  // while the block comes to rest, and at rest
    slope.s.step(steps);
    const HydroInstance& sensor = slope.s.sensor();
    const Wrench& wrench = sensor.sensed().pairs.at(0).wrench;
    EXPECT_LT(wrench.force.x, 0);
    EXPECT_NEAR(sensor.reading().shear.at(0).y, wrench.force.x, 1e-3 * weight) << steps;
    EXPECT_NEAR(sensor.reading().shear.at(0).x, wrench.force.y, 1e-3 * weight) << steps;
  }
  EXPECT_NEAR(slope.s.sensor().reading().shear[0].y, -weight * std::sin(theta), 2e-3 * weight);
}

TEST(StickingSensor, ReadsNoSlipAtRestAndFullSlipInMotion) {
  StickingSlope rest("Euler", 5 * kPi / 180), slide("Euler", 35 * kPi / 180);
  ASSERT_NE(rest.s.model, nullptr) << rest.s.error;
  rest.s.step(500);
  slide.s.step(500);
  const int last = rest.s.model->nsensordata - 1;
  EXPECT_LT(rest.s.data->sensordata[last], 0.01);
  EXPECT_EQ(slide.s.data->sensordata[last], 1);
  EXPECT_EQ(slide.s.sensor().slip(), std::vector<double>{1});
}

TEST(StickingSensor, ReadsIncipientSlipBeforeTheBlockSlides) {
  StickingSlope slope("Euler", 0);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  slope.s.step(500);
  std::vector<double> slip;
  for (int n = 0; n < 1000; ++n) {
    slope.s.data->qfrc_applied[0] = 0.49 * 0.1 * kGravity * n / 1000;  // mu is 0.5
    slope.s.step();
    slip.push_back(slope.s.sensor().slip().at(0));
  }
  EXPECT_LT(std::abs(slope.s.data->qvel[0]), 1e-4);
  EXPECT_LT(slip.front(), 0.01);
  EXPECT_GT(slip.back(), 0.05);
  EXPECT_LT(slip.back(), 1);
  EXPECT_LT(slip[300], slip.back());
}

// A push that is over leaves a deflection, and with it a shear, in contrast to regularised friction.
TEST(StickingSensor, RemembersAPushAsShear) {
  for (const Aggregate aggregate : {Aggregate::force, Aggregate::weighted_mean}) {
    StickingSlope slope("Euler", 0, true, aggregate);
    ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
    slope.s.step(300);
    slope.s.data->qfrc_applied[0] = 0.2;
    slope.s.step(500);
    const double shear = slope.s.sensor().reading().shear.at(0).y;
    EXPECT_LT(std::abs(slope.s.data->qvel[0]), 1e-9);
    if (aggregate == Aggregate::force) {
      EXPECT_NEAR(shear, -0.2, 1e-3);
    } else {
      EXPECT_NEAR(shear / slope.s.sensor().reading().values[0], -0.2 / (0.1 * kGravity), 0.05);
    }
  }
}

TEST(StickingSensor, ErrorsNameTheKeyAndTheRemedy) {
  const auto error_of = [](const std::string& keys, const Material& material) {
    SensorScene s;
    s.add_sensor("block", make_box({0.03, 0.03, 0.015}), material);
    s.compile("<mujoco>" + sensor_extension("block", key("others", "floor") + keys) +
              R"(<asset><mesh name='block' file='block.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body pos='0 0 1'><freejoint/><geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body>
      </worldbody></mujoco>)");
    return s.model == nullptr ? s.error : std::string("no error");
  };
  const Material soft{FieldKind::pad, 2e4, 0.005, 20, 0.5}, rigid{FieldKind::pad, 0, 0, 0, 0.5};
  const std::string on = key("tangential_stiffness", "1e7");
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(contains(error_of(key("tangential_stiffness", "hard"), soft), "not negative, is \"hard\""));
  EXPECT_TRUE(contains(error_of(key("tangential_stiffness", "-1"), soft), "not negative, is \"-1\""));
  EXPECT_TRUE(contains(error_of(key("tangential_stiffness", "inf"), soft), "not negative, is \"inf\""));
  EXPECT_TRUE(contains(error_of(key("bristles", "100"), soft), "give \"tangential_stiffness\" as well"));
  EXPECT_TRUE(contains(error_of(on + key("bristles", "0"), soft), "whole number above 0"));
  EXPECT_TRUE(contains(error_of(on + key("bristles", "20001"), soft), "at most 20000, is 20001"));
  EXPECT_TRUE(contains(error_of(key("output", "slip"), soft), "give \"tangential_stiffness\" as well"));
  EXPECT_TRUE(contains(error_of(on, rigid), "needs a soft body"));
  EXPECT_EQ(error_of(on + key("bristles", "20"), soft), "no error");
}

// Two soft blocks with one taxel each, one on the other: both read the same friction, in opposite directions.
TEST(StickingSensor, SharesTheFrictionOfTwoSensors) {
  SensorScene s;
  std::string instances;
  for (const std::string name : {"above", "below"}) {
    s.add_sensor(name, make_box({0.03, 0.03, 0.015}), {FieldKind::pad, 2e4, 0.005, 20, 0.5});
    Layout layout = read_layout(s.folder / (name + ".taxels.json"));
    layout.readout.aggregate = Aggregate::force;
    layout.readout.shear = true;
    layout.receptive_field.max_angle_deg = 180;
    layout.taxels[0].radius = 0.05;
    if (name == "below") layout.taxels[0].center = {0, 0, 0.015}, layout.taxels[0].normal = {0, 0, 1};
    write_layout(s.folder / (name + ".taxels.json"), layout);
    instances += "<instance name='" + name + "'>" + key("layout", name + ".taxels.json") + key("geom", name) +
                 key("others", name == "above" ? "below" : "above") + key("tangential_stiffness", "1e7") +
                 key("bristles", "300") + "</instance>";
  }
  s.compile("<mujoco><option gravity='1 0 -9.81'/><extension><plugin plugin='taxel.sensor'>" + instances +
            R"(</plugin></extension><sensor><plugin plugin='taxel.sensor' instance='above'/>
      <plugin plugin='taxel.sensor' instance='below'/></sensor><default><geom contype='0' conaffinity='0'/></default>
      <asset><mesh name='above' file='above.obj'/><mesh name='below' file='below.obj'/></asset><worldbody>
      <geom name='below' type='mesh' mesh='below'/>
      <body pos='0 0 0.0299'><freejoint/><inertial mass='0.1' pos='0 0 -0.014' diaginertia='3.7e-5 3.7e-5 6e-5'/>
        <geom name='above' type='mesh' mesh='above'/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step(500);
  EXPECT_LT(std::abs(s.data->qvel[0]), 1e-5);
  const HydroInstance &above = s.sensor(0), &below = s.sensor(1);
  const double shear = below.sensed().pairs.at(0).wrench.force.x;
  EXPECT_NEAR(shear, 0.1, 1e-4);
  // The traction is resolved to the distance of the roots, 7 mm.
  EXPECT_NEAR(glm::length(above.reading().shear.at(0)), 0.1, 2e-3);
  EXPECT_NEAR(glm::length(below.reading().shear.at(0)), glm::length(above.reading().shear.at(0)), 1e-5);
  // Friction holds the upper block with -0.1 N along x. Its e2 is +x, that of the lower block is -x.
  EXPECT_NEAR(above.reading().shear[0].y, -0.1, 2e-3);
  EXPECT_NEAR(below.reading().shear[0].y, -0.1, 2e-3);
  ASSERT_EQ(below.slip().size(), 1U);
  EXPECT_LT(below.slip()[0], 1);
}

/// Returns the slip at the vertices of the first surface.
std::vector<double> slips_of(const SensorStep& step) {
  std::vector<double> slips;
  for (const dvec3& vertex : step.surfaces.at(0).vertices) slips.push_back(step.sticking.at(0).slip_at(vertex));
  return slips;
}

// The motion of bristles does not give their friction, so the history and saved steps keep shear and slip as they are.
TEST(StickingSensor, KeepsShearAndSlipInTheHistoryAndInASavedStep) {
  StickingSlope slope("Euler", 20 * kPi / 180, true);
  ASSERT_NE(slope.s.model, nullptr) << slope.s.error;
  test::RecordedSimulation run{Simulator::load(slope.s.folder / "scene.xml"), {}, {}};
  run.skip(20);
  for (int n = 0; n < 5; ++n) {
    run.step();
    const SimFrame now = run.now(), recorded = run.recorded(now.step);
    const SensorStep &expected = now.sensors.at(0), &kept = recorded.sensors.at(0);
    ASSERT_EQ(expected.slip.size(), 1U);
    EXPECT_GT(glm::length(expected.shear.at(0)), 0.01);
    ASSERT_EQ(expected.motions.size(), expected.surfaces.size());
    EXPECT_EQ(kept.motions.at(0).V.linear, expected.motions[0].V.linear);
    EXPECT_EQ(kept.slip, expected.slip);
    EXPECT_EQ(kept.shear, expected.shear);
    EXPECT_EQ(kept.hits.size(), expected.hits.size());
    ASSERT_EQ(expected.sticking.size(), expected.surfaces.size());
    const std::vector<double> slips = slips_of(expected);
    EXPECT_EQ(slips.size(), expected.surfaces.at(0).vertices.size());
    EXPECT_EQ(slips_of(kept), slips);
    write_file_atomically(slope.s.folder / "step.taxelframe", frame_to_bundle(recorded));
    const SimFramePtr opened = read_frame_bundle(slope.s.folder / "step.taxelframe");
    EXPECT_EQ(opened->sensors.at(0).slip, expected.slip);
    EXPECT_EQ(opened->sensors.at(0).shear, expected.shear);
    EXPECT_EQ(slips_of(opened->sensors.at(0)), slips);
  }
}

}  // namespace
}  // namespace taxel
