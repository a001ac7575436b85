// The kept shear of a step: recomputed by the history, or written by a saved step, both with the same bits.
#include <gtest/gtest.h>

#include "core/layout/words.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/run/recording/recording_files.h"
#include "fixtures/box_sweep.h"
#include "fixtures/recorded_simulation.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

class KeptShear : public testing::TestWithParam<Aggregate> {
 protected:
  static SensorModelPtr model(Aggregate how) {
    const SensorModelPtr plain = test::fingertip_model(1e5);
    Layout layout = plain->layout;
    layout.readout.aggregate = how;
    layout.readout.shear = true;
    return build_sensor_model(layout, plain->mesh, plain->layout.mesh.sha256, "with shear");
  }
  /// Returns a run that slides and is recorded.
  static test::RecordedSimulation in_contact() {
    test::RecordedSimulation run{Simulator::make_scenario(model(GetParam()), test::box_sweep()), {}, {}};
    run.skip(1500);
    run.step();
    return run;
  }
  static double largest(const SimFrame& frame) {
    double size = 0;
    for (const dvec2& shear : frame.sensors[0].shear) size = std::max(size, glm::length(shear));
    return size;
  }
};

TEST_P(KeptShear, HasTheSameBitsInTheHistoryOfAReplacedLayout) {
  test::RecordedSimulation run = in_contact();
  std::vector<SimFrame> kept{run.now()};
  for (int i = 0; i < 10; ++i) run.step(), kept.push_back(run.now());
  const SensorModelPtr before = run.simulator->scene()->sensors[0];
  Layout without = before->layout;
  without.readout.shear = false;
  run.simulator->replace_model(before, build_sensor_model(without, before->mesh, without.mesh.sha256, "without"));
  run.history.replace_newest(run.simulator->view());
  EXPECT_TRUE(run.recorded(run.history.last()).sensors[0].shear.empty());
  kept.pop_back();
  for (const SimFrame& frame : kept) {
    EXPECT_GT(largest(frame),
              0.01 * std::abs(*std::max_element(frame.sensors[0].readings.begin(), frame.sensors[0].readings.end())));
    test::expect_same_step(run.recorded(frame.step), frame);
  }
}

TEST_P(KeptShear, HasTheSameBitsInASavedStep) {
  test::RecordedSimulation run = in_contact();
  const SimFrame frame = run.now();
  ASSERT_GT(largest(frame), 0);
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "sliding.taxelframe";
  const std::string bytes = frame_to_bundle(frame);
  write_file_atomically(file, bytes);
  const SimFramePtr opened = read_frame_bundle(file);
  test::expect_same_step(*opened, frame);
  EXPECT_EQ(frame_to_bundle(*opened), bytes);
  // From the history as well.
  write_file_atomically(file, frame_to_bundle(run.recorded(frame.step)));
  test::expect_same_step(*read_frame_bundle(file), frame);
  EXPECT_EQ(NpzReader(file).shape("sensor0/shear"), (NpzReader::Shape{12, 2}));
}

INSTANTIATE_TEST_SUITE_P(Aggregates, KeptShear, testing::Values(Aggregate::weighted_mean, Aggregate::force),
                         [](const auto& of) { return std::string(to_word(of.param)); });

}  // namespace
}  // namespace taxel
