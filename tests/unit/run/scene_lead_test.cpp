// Controls and poses over time that lead a scene: the values between rows in closed form, and the tables.
#include "core/run/lead.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

/// Returns the rotation about an axis by an angle.
dquat turn(double angle, const dvec3& axis) {
  return {std::cos(angle / 2), std::sin(angle / 2) * axis};
}

TEST(SceneLead, IsLinearBetweenRowsAndHeldOutside) {
  const ControlTrack track{0, {1, 2, 4}, {10, 20, -20}};
  EXPECT_EQ(control_at(track, 0), 10);
  EXPECT_EQ(control_at(track, 1), 10);
  EXPECT_DOUBLE_EQ(control_at(track, 1.25), 12.5);
  EXPECT_EQ(control_at(track, 2), 20);
  EXPECT_DOUBLE_EQ(control_at(track, 2.5), 10);
  EXPECT_EQ(control_at(track, 4), -20);
  EXPECT_EQ(control_at(track, 9), -20);
}

TEST(SceneLead, TurnsAtAnEvenSpeedTheShorterWay) {
  const dvec3 axis = glm::normalize(dvec3(1, -2, 3));
  MocapTrack track{0, {0, 2, 3}, {{0, 0, 0}, {1, 2, 4}, {1, 2, 4}}, {turn(0.2, axis), turn(1.4, axis), {}}};
  track.rotations_WB[2] = -turn(2.0, axis);  // the same rotation as its negative
  for (const double time : {0.0, 0.5, 1.0, 1.7, 2.0}) {
    const dquat q = rotation_at(track, time), expected = turn(0.2 + 1.2 * time / 2, axis);  // angle linear in time
    EXPECT_NEAR(std::abs(glm::dot(q, expected)), 1, 1e-15) << time;
    EXPECT_LT(glm::distance(position_at(track, time), dvec3(0.5, 1, 2) * time), 1e-15) << time;
  }
  EXPECT_NEAR(std::abs(glm::dot(rotation_at(track, 2.5), turn(1.7, axis))), 1, 1e-15);
  EXPECT_EQ(rotation_at(track, 2), track.rotations_WB[1]) << "the row itself, bit for bit";
  EXPECT_EQ(rotation_at(track, 3), track.rotations_WB[2]);
  EXPECT_EQ(rotation_at(track, 7), track.rotations_WB[2]);
}

TEST(SceneLead, EndsWithTheStepOfTheLastRow) {
  SceneLead lead;
  lead.controls.push_back({0, {0, 0.07}, {0, 1}});
  EXPECT_EQ(steps_of(lead, 0.01), 8);  // 0.07 / 0.01 is a little above 7
  lead.mocaps.push_back({0, {0, 0.071}, {{}, {}}, {}});
  EXPECT_EQ(steps_of(lead, 0.01), 9);
  EXPECT_EQ(end_of(lead), 0.071);
  lead.controls.back().times.back() = 1e300;
  EXPECT_GT(steps_of(lead, 0.01), 1'000'000'000'000);  // refused as too long, by whoever runs it
}

SceneControls scene() {
  SceneControls controls;
  controls.actuators = {{"wrist", ControlRange{-1, 1}}, {"curl", {}}};
  controls.mocaps = {"palm", "ball"};
  controls.keyframes = {{"open", 0}, {"1", 0}, {"closed", 0}};
  return controls;
}

/// Returns what(), or an empty text if nothing is thrown.
template <class Function>
std::string error_of(const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
std::string control_error(const std::string& text) {
  SceneLead lead;
  return error_of([&] { add_controls(lead, text, scene(), "t.csv"); });
}
std::string mocap_error(const std::string& text, SceneControls of = scene()) {
  SceneLead lead;
  return error_of([&] { add_mocaps(lead, text, of, "t.csv"); });
}

TEST(LeadTable, ReadsControlsOfAnyOrderUnitAndDecimalMark) {
  SceneLead lead;
  add_controls(lead, "curl;t [ms];wrist [deg]\n0,5;0;90\n1,5;500;-180\n", scene(), "t.csv");
  ASSERT_EQ(lead.controls.size(), 2U);
  EXPECT_EQ(lead.controls[0].actuator, 1);
  EXPECT_EQ(lead.controls[0].values, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(lead.controls[1].times, (std::vector<double>{0, 0.5}));
  EXPECT_NEAR(lead.controls[1].values[0], kPi / 2, 1e-15);
  ASSERT_EQ(lead.notes.size(), 1U);
  EXPECT_EQ(lead.notes[0].find("actuator \"wrist\": 2 of 2 values are outside of its range, -1 to 1, and are clamped"),
            0U)
      << lead.notes[0];
}

TEST(LeadTable, RefusesBadControlsByLineAndColumn) {
  EXPECT_EQ(control_error("time,wirst\n0,1\n1,1\n"),
            "t.csv: column \"wirst\": names no actuator of the scene; there are \"wrist\", \"curl\"; did "
            "you mean \"wrist\"?");
  EXPECT_EQ(control_error("0,1\n1,1\n"),
            "t.csv: line 1: is not a header: the first line must name the columns, time and actuators: \"wrist\", "
            "\"curl\"");
  EXPECT_EQ(control_error("wrist,curl\n0,1\n1,1\n"),
            "t.csv: has no column of times: name one \"time\" or \"t\"; there are wrist, curl");
  EXPECT_EQ(control_error("time,wrist\n0,1\n2,1\n1,1\n"),
            "t.csv: line 4, column \"time\": time runs backwards: 1 s after 2 s");
  EXPECT_EQ(control_error("time,wrist\n0,1\n2,1\n2,5\n"),
            "t.csv: line 4, column \"time\": the row before has the same time, 2 s: for a jump, add a little to this "
            "time");
  EXPECT_EQ(control_error("time,wrist\n0,1\n1,nan\n"),
            "t.csv: line 3, column \"wrist\": the value is missing: every row needs all values");
  EXPECT_EQ(control_error("time,wrist\n0,up\n1,1\n"), "t.csv: line 2, column \"wrist\": is no number: \"up\"");
  EXPECT_EQ(control_error("time,wrist\n0,1\n1\n"), "t.csv: line 3: has 1 columns, not 2");
  EXPECT_EQ(control_error("time,wrist\n"), "t.csv: has 1 lines, of which 1 are header: no row");
  EXPECT_EQ(control_error(""), "t.csv: has 0 lines, of which 1 are header: no row");
  EXPECT_EQ(control_error("time\n0\n1\n"),
            "t.csv: has no column apart from the times: add a column for an actuator, \"wrist\", \"curl\"");
  EXPECT_EQ(control_error("time,wrist,wrist\n0,1,1\n1,1,1\n"),
            "t.csv: column \"wrist\": leads the same actuator as another column");
  EXPECT_EQ(control_error("time [min],wrist\n0,1\n1,1\n"),
            "t.csv: column \"time [min]\": the unit must be s, ms, us or ns, is \"min\"");
}

TEST(LeadTable, ReadsPosesOfOneOrSeveralBodies) {
  SceneLead lead;
  add_mocaps(lead,
             "time,ball_x [mm],ball_y [mm],ball_z [mm],palm_z,palm_x,palm_y,palm_qw,palm_qx,palm_qy,palm_qz\n"
             "0,1,2,3,0.3,0.1,0.2,0.999,0,0,0\n1,1,2,5,0.3,0.1,0.2,0,0,1,0\n",
             scene(), "t.csv");
  ASSERT_EQ(lead.mocaps.size(), 2U);
  EXPECT_EQ(lead.mocaps[0].positions_W[0], dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(lead.mocaps[0].rotations_WB[0], dquat(1, 0, 0, 0));
  EXPECT_EQ(lead.mocaps[0].rotations_WB[1], dquat(0, 0, 1, 0));
  EXPECT_EQ(lead.mocaps[1].mocap, 1);
  EXPECT_EQ(lead.mocaps[1].positions_W[1], dvec3(0.001, 0.002, 0.005));
  EXPECT_TRUE(lead.mocaps[1].rotations_WB.empty());
  SceneControls one = scene();
  one.mocaps = {"palm"};
  SceneLead plain;
  add_mocaps(plain, "t x y z\n0 1 2 3\n1 1 2 4\n", one, "t.txt");
  EXPECT_EQ(plain.mocaps.at(0).positions_W[1], dvec3(1, 2, 4));
}

TEST(LeadTable, RefusesBadPosesByLineAndColumn) {
  const std::string columns =
      "BODY_x, BODY_y, BODY_z, and BODY_qw, _qx, _qy, _qz for an orientation; the mocap bodies "
      "are \"palm\", \"ball\"";
  EXPECT_EQ(mocap_error("time,x,y,z\n0,1,1,1\n1,1,1,1\n"),
            "t.csv: column \"x\": names no coordinate of a mocap body; columns are " + columns);
  EXPECT_EQ(mocap_error("time,palm_x,palm_z\n0,1,1\n1,1,1\n"),
            "t.csv: column \"palm_y\": is missing: a led body needs x, y and z");
  EXPECT_EQ(mocap_error("time,palm_x,palm_y,palm_z,palm_qw\n0,1,1,1,1\n1,1,1,1,1\n"),
            "t.csv: column \"palm_qx\": is missing: a led orientation needs qw, qx, qy and qz");
  EXPECT_EQ(
      mocap_error("time,palm_x,palm_y,palm_z,palm_qw,palm_qx,palm_qy,palm_qz\n0,1,1,1,1,0,0,0\n1,1,1,1,1,0,1,0\n"),
      "t.csv: line 3, column \"palm_qw\": the quaternion qw, qx, qy, qz must have the length 1 within 1 %, has "
      "1.41421");
  EXPECT_EQ(mocap_error("time,palm_x [kg],palm_y,palm_z\n0,1,1,1\n1,1,1,1\n"),
            "t.csv: column \"palm_x [kg]\": \"kg\" must be a length");
  EXPECT_EQ(mocap_error("time,palm_x\n", SceneControls{}),
            "t.csv: leads mocap bodies, but the scene has none (a body with mocap=\"true\")");
}

TEST(LeadTable, FindsKeyframesByNameThenByNumber) {
  EXPECT_EQ(keyframe_named("closed", scene(), "s.xml"), 2);
  EXPECT_EQ(keyframe_named("0", scene(), "s.xml"), 0);
  EXPECT_EQ(keyframe_named("1", scene(), "s.xml"), 1);
  EXPECT_EQ(error_of([] { keyframe_named("7", scene(), "s.xml"); }),
            "s.xml: has no keyframe \"7\"; there are \"open\", \"1\", \"closed\" (numbers 0 to 2)");
  EXPECT_EQ(error_of([] { keyframe_named("0", SceneControls{}, "s.xml"); }), "s.xml: has no keyframe");
}

}  // namespace
}  // namespace taxel
