// The row of a trace: readings, shear and slip of all sensors of a step, one sensor after the other.
#include "core/run/step.h"

#include <gtest/gtest.h>

namespace taxel {
namespace {

TEST(TraceRow, HasNeitherShearNorSlipIfNoSensorHas) {
  const std::vector<double> readings{1, 2};
  StepView step;
  step.time = 0.5, step.travel = 0.01;
  step.sensors.resize(1);
  step.sensors[0].readings = readings;
  const TraceRow row = trace_row_of(step, SampleQuality::preview);
  EXPECT_EQ(row.time, 0.5);
  EXPECT_EQ(row.travel, 0.01);
  EXPECT_EQ(row.readings, readings);
  EXPECT_EQ(row.quality, SampleQuality::preview);
  EXPECT_TRUE(row.shear.empty());
  EXPECT_TRUE(row.slip.empty());
}

TEST(TraceRow, FillsSensorsWithoutShearOrSlipWithZeros) {
  const std::vector<double> first{1, 2}, second{3}, third{4}, slip{0.75};
  const std::vector<dvec2> shear{{3, -4}};
  StepView step;
  step.sensors.resize(3);
  step.sensors[0].readings = first;
  step.sensors[1].readings = second;
  step.sensors[1].shear = shear;
  step.sensors[1].slip = slip;
  step.sensors[2].readings = third;
  const TraceRow row = trace_row_of(step, SampleQuality::polished);
  EXPECT_EQ(row.readings, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(row.shear, (std::vector<double>{0, 0, 5, 0}));
  EXPECT_EQ(row.slip, (std::vector<double>{0, 0, 0.75, 0}));
}

}  // namespace
}  // namespace taxel
