// The part of a run with contact.
#include "core/run/history/contact_steps.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace taxel {
namespace {

/// Returns rows of two sensors, a step of 10 ms each, from step 100 on. The second sensor has polygons in `touching`.
HistoryLanes touching_lanes(std::size_t rows, const std::vector<std::size_t>& touching) {
  HistoryLanes lanes;
  lanes.sensor_count = 2;
  for (std::size_t row = 0; row < rows; ++row) {
    lanes.steps.push_back({100 + row, 0.01 * static_cast<double>(row), 0, 0});
    lanes.sensors.push_back({});
    SensorSummary second;
    second.polygons = std::find(touching.begin(), touching.end(), row) != touching.end() ? 3 : 0;
    lanes.sensors.push_back(second);
  }
  return lanes;
}

TEST(ContactSteps, LastFromTheFirstToTheLastTouch) {
  const HistoryLanes lanes = touching_lanes(100, {30, 31, 50});
  EXPECT_EQ(contact_steps(lanes, {100, 199}, 0), (StepRange{130, 150}));
  EXPECT_EQ(contact_steps(lanes, {100, 199}, 0.025), (StepRange{128, 152}));
  EXPECT_EQ(contact_steps(lanes, {100, 199}, 10), (StepRange{100, 199})) << "the margin ends with the run";
}

TEST(ContactSteps, StayInTheLoop) {
  const HistoryLanes lanes = touching_lanes(100, {30, 50});
  EXPECT_EQ(contact_steps(lanes, {140, 160}, 0.005), (StepRange{150, 150}));
  EXPECT_EQ(contact_steps(lanes, {149, 151}, 1), (StepRange{149, 151}));
  EXPECT_FALSE(contact_steps(lanes, {131, 149}, 1));
}

TEST(ContactSteps, AreNoneWithoutATouch) {
  EXPECT_FALSE(contact_steps(touching_lanes(10, {}), {100, 109}, 1));
  EXPECT_FALSE(contact_steps({}, {0, 0}, 1));
}

}  // namespace
}  // namespace taxel
