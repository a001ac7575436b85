// The range of the readings, apart from that of the contact surface.
#include "app/studio/frame/sensors_shown.h"

#include <gtest/gtest.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui::test {
namespace {

/// Two sensors in SIMULATE whose readings peaked at 900 Pa and 4100 Pa, under a surface range of 40 kPa.
struct TwoSensors {
  ToolScene scene{{dvec3(1, 0, 0), dvec3(1, 0.5, 0)}};
  std::shared_ptr<SimScene> parts = std::make_shared<SimScene>();
  std::shared_ptr<SimFrame> frame = std::make_shared<SimFrame>();
  Viewer& viewer = *scene.app.viewer;
  Shown& shown = *scene.app.shown;
  TwoSensors() {
    viewer.mode = Mode::simulate;
    viewer.range.hi = 40'000;
    parts->sensors = {shown.document.model, shown.document.model};
    frame->scene = parts;
    frame->sensors.resize(2);
    for (SensorStep& sensor : frame->sensors) sensor.readings = {100, 200};
    shown.run.frame = frame;
    shown.run.sensor_peaks = {900, 4100};
  }
  /// Makes a sensor read forces.
  void read_force(std::size_t sensor) {
    auto model = std::make_shared<SensorModel>(*shown.document.model);
    model->layout.readout.aggregate = Aggregate::force;
    parts->sensors[sensor] = model;
  }
  [[nodiscard]] PressureRange range() const { return reading_range(viewer, shown); }
};

TEST(ReadingRange, FollowsTheLargestReadingOfAllSensors) {
  TwoSensors two;
  EXPECT_EQ(two.range().hi, 5000);
  EXPECT_EQ(two.range().lo, 0);
  EXPECT_TRUE(two.range().automatic);
  two.frame->sensors[0].readings = {0, 0};
  EXPECT_EQ(two.range().hi, 5000) << "it does not shrink while the readings fall";
  two.shown.run.sensor_peaks = {900, 0};
  EXPECT_EQ(two.range().hi, 1000);
  two.shown.run.sensor_peaks = {0, 0};
  EXPECT_EQ(two.range().hi, 1000) << "1 kPa without a reading";
}

TEST(ReadingRange, LeavesOutSensorsInAnotherUnit) {
  TwoSensors two;
  two.read_force(1);
  two.shown.run.sensor_peaks = {900, 0.35};
  EXPECT_EQ(two.range().hi, 1000);
  two.viewer.selection.sensor = 1;
  two.frame->sensors[1].readings = {0.1, 0.2};
  EXPECT_EQ(two.range().hi, 0.4);
  EXPECT_STREQ(unit_of_readings(two.viewer, two.shown).text, "N");
}

TEST(ReadingRange, StaysWhereItIsLockedInItsUnitOnly) {
  TwoSensors two;
  toggle_reading_lock(two.viewer, two.shown);
  two.shown.run.sensor_peaks = {900, 30'000};
  EXPECT_EQ(two.range().hi, 5000);
  EXPECT_FALSE(two.range().automatic);
  two.read_force(1);
  two.viewer.selection.sensor = 1;
  two.shown.run.sensor_peaks = {900, 0.35};
  two.frame->sensors[1].readings = {0, 0};
  EXPECT_EQ(two.range().hi, 0.4) << "5000 N would be nonsense";
  two.viewer.selection.sensor = 0;
  toggle_reading_lock(two.viewer, two.shown);
  EXPECT_TRUE(two.range().automatic);
}

TEST(ReadingRange, IsThatOfTheSurfaceWhileLinked) {
  TwoSensors two;
  two.viewer.readings.linked = true;
  EXPECT_EQ(two.range(), two.viewer.range);
  EXPECT_TRUE(shares_range(two.viewer, two.shown));
  two.read_force(0);
  two.shown.run.sensor_peaks = {0.35, 0};
  two.frame->sensors[0].readings = {0, 0};
  EXPECT_FALSE(shares_range(two.viewer, two.shown)) << "newtons and pascals have no common range";
  EXPECT_EQ(two.range().hi, 0.4);
}

}  // namespace
}  // namespace taxel::ui::test
