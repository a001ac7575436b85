// Recordings as messages of tactile_msgs/TactileState: its fields, stamps in whole nanoseconds, values in single
// precision.
#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/run/recording/recording_files.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

Recording two_sensors() {
  Recording recording;
  recording.sensors = {{"left \"tip\"", {7, 3}, {"", ""}, "{}", "Pa", 1}, {"right", {1}, {""}, "{}", "Pa", 1}};
  recording.sensors[1].calibrated_unit = "V";
  SensorRecord left, right;
  left.readings = {0, 1.0 / 3.0};
  right.readings = {5};
  right.calibrated = {0.25};
  recording.rows.push_back({0, 0, 0, {left, right}, {}});
  left.readings = {1e22, -2.5};
  recording.rows.push_back({1, 12.0009999999, 0, {left, right}, {}});
  return recording;
}

TEST(TactileState, WritesOneMessagePerRowWithAllFields) {
  EXPECT_EQ(tactile_states(two_sensors()),
            R"({"header": {"seq": 0, "stamp": {"secs": 0, "nsecs": 0}, "frame_id": "world"}, "sensors": [)"
            R"({"name": "left \"tip\"", "values": [0, 0.33333334]}, {"name": "right", "values": [0.25]}]})"
            "\n"
            R"({"header": {"seq": 1, "stamp": {"secs": 12, "nsecs": 1000000}, "frame_id": "world"}, "sensors": [)"
            R"({"name": "left \"tip\"", "values": [1e+22, -2.5]}, {"name": "right", "values": [0.25]}]})"
            "\n");
  EXPECT_EQ(tactile_states({}), "");
}

TEST(TactileState, RefusesValuesThatTheMessageCannotHold) {
  Recording recording = two_sensors();
  recording.rows[1].time = -0.5;
  EXPECT_EQ(test::complaint_of([&] { tactile_states(recording); }),
            "time: a stamp of ROS is from 0 to 4294967295 s, this row is of -0.5 s");
  recording = two_sensors();
  recording.rows[1].sensors[0].readings[1] = 1e300;
  EXPECT_EQ(test::complaint_of([&] { tactile_states(recording); }),
            "sensor \"left \"tip\"\": taxel 3: 1e+300 at 12.0009999999 s is no finite single");
}

}  // namespace
}  // namespace taxel
