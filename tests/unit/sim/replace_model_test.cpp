// A sensor's samples are replaced during the simulation: the state continues, and the new samples read it from the same
// step on.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/sim_host.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/fill_frame.h"

namespace taxel {
namespace {

const std::filesystem::path kFile = std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/layouts/fingertip.taxels.json";
constexpr int kStepsUntilContact = 1700;  // steps of the sweep

class ReplaceModel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    source_ = std::make_unique<SensorSource>(read_sensor_source(kFile));
    source_->layout.sampling.density = 1e6;
    SensorCache cache;
    preview_ = build(cache, SampleQuality::preview);
    polished_ = build(cache, SampleQuality::polished);
  }
  static void TearDownTestSuite() {
    source_.reset();
    preview_.reset();
    polished_.reset();
  }
  static SensorModelPtr build(SensorCache& cache, SampleQuality quality) {
    SensorBuild how;
    how.cache = &cache;
    how.quality = quality;
    return build_sensor_model(*source_, how);
  }
  static std::unique_ptr<Simulator> sweep(const SensorModelPtr& model, int steps) {
    auto simulator = Simulator::make_scenario(model, test::box_sweep());
    for (int i = 0; i < steps; ++i) simulator->step();
    return simulator;
  }
  static std::unique_ptr<SensorSource> source_;
  static SensorModelPtr preview_, polished_;
};
std::unique_ptr<SensorSource> ReplaceModel::source_;
SensorModelPtr ReplaceModel::preview_, ReplaceModel::polished_;

/// Expects equal values of one state, all read by the same model.
void expect_same_step(const Simulator& a, const Simulator& b) {
  SimFrame x, y;
  test::fill_frame(a, x);
  test::fill_frame(b, y);
  EXPECT_EQ(x.step, y.step);
  EXPECT_EQ(x.time, y.time);
  EXPECT_EQ(x.scene->sensors, y.scene->sensors);
  ASSERT_EQ(x.sensors.size(), 1u);
  EXPECT_EQ(x.sensors[0].readings, y.sensors[0].readings);
  EXPECT_EQ(x.sensors[0].force_W, y.sensors[0].force_W);
  EXPECT_EQ(x.sensors[0].X_WM.p, y.sensors[0].X_WM.p);
  ASSERT_EQ(x.sensors[0].hits.size(), x.scene->sensors[0]->rays.size());
  ASSERT_EQ(x.sensors[0].hits.size(), y.sensors[0].hits.size());
  for (std::size_t i = 0; i < x.sensors[0].hits.size(); ++i)
    EXPECT_EQ(x.sensors[0].hits[i].pressure, y.sensors[0].hits[i].pressure);
}

TEST_F(ReplaceModel, ReadsThePresentStateWithTheNewSamples) {
  const auto simulator = sweep(preview_, kStepsUntilContact), whole = sweep(polished_, kStepsUntilContact);
  const std::vector<double> before = row_of(simulator->view()).sensors[0].readings;
  simulator->replace_model(preview_, polished_);
  EXPECT_NE(row_of(simulator->view()).sensors[0].readings, before) << "other samples read a little else";
  expect_same_step(*simulator, *whole);
  for (int i = 0; i < 20; ++i) simulator->step(), whole->step();
  expect_same_step(*simulator, *whole);
  EXPECT_GT(*std::max_element(before.begin(), before.end()), 1000) << "Pa: in contact";
}

TEST_F(ReplaceModel, KeepsTheNewModelAfterAReset) {
  const auto simulator = sweep(preview_, 3), whole = sweep(polished_, 0);
  simulator->reset();
  simulator->replace_model(preview_, polished_);
  expect_same_step(*simulator, *whole);
  for (int i = 0; i < 50; ++i) simulator->step(), whole->step();
  expect_same_step(*simulator, *whole);
}

TEST_F(ReplaceModel, ChangesNothingForAnUnusedModel) {
  const auto simulator = sweep(polished_, 10);
  const auto scene = simulator->scene();
  simulator->replace_model(preview_, polished_);
  EXPECT_EQ(simulator->scene(), scene);
}

TEST_F(ReplaceModel, ContinuesFromTheSameStateWithAnotherBody) {
  const auto simulator = sweep(polished_, kStepsUntilContact);
  SimFrame before, after;
  test::fill_frame(*simulator, before);
  Layout layout = source_->layout;
  layout.material.modulus *= 2;
  const SensorModelPtr stiffer = build_sensor_model(layout, source_->mesh.mesh, source_->mesh.sha256, "stiffer");
  simulator->replace_model(polished_, stiffer);
  test::fill_frame(*simulator, after);
  EXPECT_EQ(after.scene->sensors[0], stiffer);
  EXPECT_EQ(after.step, before.step);
  const auto largest = [](const SimFrame& f) {
    return *std::max_element(f.sensors[0].readings.begin(), f.sensors[0].readings.end());
  };
  EXPECT_NEAR(largest(after), 2 * largest(before), 0.1 * largest(before));
}

TEST_F(ReplaceModel, RefusesAnotherNumberOfTaxelsAndKeepsTheSensor) {
  const auto simulator = sweep(preview_, kStepsUntilContact), untouched = sweep(preview_, kStepsUntilContact);
  Layout layout = source_->layout;
  layout.taxels.pop_back();
  const SensorModelPtr fewer = build_sensor_model(layout, source_->mesh.mesh, source_->mesh.sha256, "fewer");
  EXPECT_THROW(simulator->replace_model(preview_, fewer), Error);
  simulator->step(), untouched->step();
  expect_same_step(*simulator, *untouched);
}

TEST_F(ReplaceModel, MarksRowsWithTheQualityOfTheirSamples) {
  InlineSim sim;
  sim.send(LoadScenarioCommand{preview_, test::box_sweep()});
  sim.send(StepCommand{25});
  sim.send(ReplaceModelCommand{preview_, polished_});
  sim.send(StepCommand{25});
  const SimFramePtr frame = sim.take().frame;
  ASSERT_TRUE(frame && frame->step == 50);
  EXPECT_EQ(frame->error, "");
  EXPECT_EQ(frame->scene->sensors[0], polished_);
  std::vector<SampleQuality> rows;
  for (const TraceRow& row : frame->trace->rows) rows.push_back(row.quality);
  EXPECT_EQ(rows, (std::vector<SampleQuality>{SampleQuality::preview, SampleQuality::preview, SampleQuality::preview,
                                              SampleQuality::polished, SampleQuality::polished}))
      << "at steps 0, 10, 20 and 30, 40";
}

}  // namespace
}  // namespace taxel
