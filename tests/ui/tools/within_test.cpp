// The switch "Within 1 %": which edit it makes for which error bars, and when it waits.
#include "app/studio/nouns/bars/bars_state.h"

#include <gtest/gtest.h>

#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A run of the document's layout with one sensor whose largest reading is 1000 Pa, and with measured bars.
struct MeasuredRun {
  Shown shown;
  std::shared_ptr<SensorModel> model = std::make_shared<SensorModel>();
  std::shared_ptr<SimFrame> frame = std::make_shared<SimFrame>();
  std::shared_ptr<MeasuredErrors> errors = std::make_shared<MeasuredErrors>();

  explicit MeasuredRun(double bar, std::size_t samples = 1000) {
    model->layout.taxels = {{7, "", dvec3(0), dvec3(0, 0, 1), 0.004, {}}, {9, "", dvec3(0), dvec3(0, 0, 1), 0.004, {}}};
    model->layout.sampling.density = 1e6;
    model->samples.resize(samples);
    model->fields.first = {0, 100, 200};  // 100 samples each
    auto scene = std::make_shared<SimScene>();
    scene->sensors = {model};
    scene->sensor_geoms = {"finger"};
    frame->scene = scene;
    frame->sensors.resize(1);
    frame->sensors[0].model = model;
    frame->sensors[0].readings = {500, 900};
    errors->id = frame->id();
    errors->bars = {{0.1 * bar, bar}};
    errors->missing = {""};
    shown.document.model = model;
    shown.document.editing.project = std::make_shared<Project>();
    shown.run.simulates_document = true;
    shown.run.frame = frame;
    shown.run.errors = errors;
    shown.run.sensor_peaks = {1000};
  }
};

TEST(Within, RestsWhileAllBarsAreSmall) {
  const WithinStep step = next_within(MeasuredRun(9).shown);
  EXPECT_FALSE(step.edit);
  EXPECT_EQ(step.text, "largest bar 0.9 % of the largest reading (taxel 9)");
}

// Bars fall with the square root of the samples: 3 % needs nine times as many, and 20 % is approached by factors of 16.
TEST(Within, MultipliesTheDensityByTheSquareOfTheBar) {
  const auto changes = [](const MeasuredRun& run) {
    const WithinStep step = next_within(run.shown);
    return step.edit ? std::get<SetTaxels>(*step.edit).changes : std::vector<TaxelChange>();
  };
  const auto expect_density = [&](const MeasuredRun& run, double expected) {
    const std::vector<TaxelChange> found = changes(run);
    ASSERT_EQ(found.size(), 1U) << "taxel 7 has a small bar";
    EXPECT_EQ(found[0].id, 9);
    EXPECT_NEAR(*found[0].density, expected, 1);
    EXPECT_FALSE(found[0].radius || found[0].center);
  };
  expect_density(MeasuredRun(30), 9e6);
  expect_density(MeasuredRun(33), 1.1e7);  // 10.89, rounded up to two digits
  expect_density(MeasuredRun(10.5), 1.5e6);
  expect_density(MeasuredRun(30, 199'500), 6e6);  // 500 samples are left
  MeasuredRun dense(30);
  dense.model->layout.taxels[1].density = 4e6;
  expect_density(dense, 3.6e7);
  const std::vector<TaxelChange> both = changes(MeasuredRun(200));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NEAR(*both[0].density, 4e6, 1);
  EXPECT_NEAR(*both[1].density, 1.6e7, 1);
}

TEST(Within, TakesExactReadingsWhereSamplesAreNotEnough) {
  const WithinStep step = next_within(MeasuredRun(30, 199'950).shown);
  ASSERT_TRUE(step.edit);
  EXPECT_EQ(std::get<SetReadout>(*step.edit).readout.method, ReadingMethod::exact);
  MeasuredRun nearest(30, 199'950);
  nearest.model->layout.readout.aggregate = Aggregate::nearest;
  EXPECT_FALSE(next_within(nearest.shown).edit);
  MeasuredRun exact(30);
  exact.model->layout.readout.method = ReadingMethod::exact;
  EXPECT_FALSE(next_within(exact.shown).edit);
}

TEST(Within, WaitsForTheMeasureOfTheNewestLayout) {
  MeasuredRun compiling(30), preview(30), older(30), other_scene(30);
  compiling.shown.document.editing.compiled = false;
  preview.model->quality = SampleQuality::preview;
  older.errors->id.step += 1;
  other_scene.shown.run.simulates_document = false;
  for (const MeasuredRun* run : {&compiling, &preview, &older, &other_scene})
    EXPECT_FALSE(next_within(run->shown).edit);
  older.shown.run.playing = true;
  EXPECT_TRUE(next_within(older.shown).edit) << "while the run plays, bars are of a moment before";
}

}  // namespace
}  // namespace taxel::ui
