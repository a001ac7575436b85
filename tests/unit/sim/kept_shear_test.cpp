// The shear of a step, kept: worked out anew by the history, written by a saved step, the same bits from both.
#include <gtest/gtest.h>

#include "core/project/recording/npz.h"
#include "core/sim/bundle/frame_bundle.h"
#include "core/sim/history/step_history.h"
#include "core/sim/simulator.h"
#include "fixtures/same_frame.h"
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
  /// Sliding, and recorded.
  void run_to_contact() {
    simulator_ = Simulator::make_scenario(model(GetParam()), {});
    for (int i = 0; i < 1500; ++i) simulator_->step();
    step();
  }
  void step() {
    simulator_->step();
    simulator_->save_state(state_);
    history_.record(simulator_->view(), state_);
  }
  [[nodiscard]] SimFrame now() const {
    SimFrame frame;
    simulator_->fill_frame(frame);
    return frame;
  }
  [[nodiscard]] SimFrame recorded(std::uint64_t number) const {
    SimFrame frame;
    history_.fill_frame(number, frame);
    return frame;
  }
  static double largest(const SimFrame& frame) {
    double size = 0;
    for (const dvec2& shear : frame.sensors[0].shear) size = std::max(size, glm::length(shear));
    return size;
  }

  std::unique_ptr<Simulator> simulator_;
  StepHistory history_;
  SimState state_;
};

TEST_P(KeptShear, TheHistoryHasTheSameBitsAlsoAfterTheLayoutWasReplaced) {
  run_to_contact();
  std::vector<SimFrame> kept{now()};
  for (int i = 0; i < 10; ++i) step(), kept.push_back(now());
  const SensorModelPtr before = simulator_->scene()->sensors[0];
  Layout without = before->layout;
  without.readout.shear = false;
  simulator_->replace_model(before, build_sensor_model(without, before->mesh, without.mesh.sha256, "without"));
  history_.replace_newest(simulator_->view());
  EXPECT_TRUE(recorded(history_.last()).sensors[0].shear.empty());
  kept.pop_back();
  for (const SimFrame& frame : kept) {
    EXPECT_GT(largest(frame),
              0.01 * std::abs(*std::max_element(frame.sensors[0].readings.begin(), frame.sensors[0].readings.end())));
    test::expect_same_frame(recorded(frame.step), frame);
  }
}

TEST_P(KeptShear, ASavedStepHasTheSameBits) {
  run_to_contact();
  const SimFrame frame = now();
  ASSERT_GT(largest(frame), 0);
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "sliding.taxelframe";
  const std::string bytes = frame_to_bundle(frame);
  write_file_atomically(file, bytes);
  const SimFramePtr opened = read_frame_bundle(file);
  test::expect_same_frame(*opened, frame);
  EXPECT_EQ(frame_to_bundle(*opened), bytes);
  // from the history as well
  write_file_atomically(file, frame_to_bundle(recorded(frame.step)));
  test::expect_same_frame(*read_frame_bundle(file), frame);
  EXPECT_EQ(NpzReader(file).shape("sensor0/shear"), (NpzReader::Shape{12, 2}));
}

INSTANTIATE_TEST_SUITE_P(Aggregates, KeptShear, testing::Values(Aggregate::weighted_mean, Aggregate::force),
                         [](const auto& of) { return std::string(to_word(of.param)); });

}  // namespace
}  // namespace taxel
