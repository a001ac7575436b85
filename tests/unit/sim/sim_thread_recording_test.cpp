// Recordings by the simulation thread: every step, with the same numbers as a plain loop, and no discarded step.
#include <gtest/gtest.h>

#include <thread>

#include "core/run/recording/recording_files.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/compare/error_bars.h"
#include "core/sim/simulator.h"
#include "fixtures/asked_sim.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Returns a model with shear and with a calibration that has a state: hysteresis between loading and unloading.
SensorModelPtr remembering_model() {
  const fs::path file = fs::path(TAXEL_SOURCE_DIR) / "assets/layouts/fingertip.taxels.json";
  Layout layout = read_layout(file);
  layout.sampling.density = 1e5;
  layout.readout.shear = true;
  layout.calibration.emplace();
  layout.calibration->hysteresis = Hysteresis{100, 1, {}};
  layout.calibration->noise = 1;
  const LoadedMesh mesh = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  return build_sensor_model(layout, mesh.mesh, mesh.sha256, file.string());
}

class ThreadRecording : public testing::Test, protected test::AskedSim {
 protected:
  static void SetUpTestSuite() { model_ = remembering_model(); }
  static void TearDownTestSuite() { model_.reset(); }
  void SetUp() override { ask(LoadScenarioCommand{model_, touching()}); }
  /// Returns a scenario that is in contact after a few steps.
  static Scenario touching() {
    Scenario scenario = test::box_sweep();
    scenario.as<scenarios::Sweep>().before = 0.002;
    scenario.as<scenarios::Sweep>().speed = 0.02;
    return scenario;
  }
  [[nodiscard]] std::string file(const char* name) const { return (folder_.path() / name).string(); }
  /// Returns the steps from `first` to `last` (counted from 1) of a plain loop.
  static Recording plain(int first, int last) {
    const auto simulator = Simulator::make_scenario(model_, touching());
    RunRecorder recorder(*simulator->scene());
    for (int step = 1; step <= last; ++step) {
      simulator->step();
      if (step >= first) recorder.follow(simulator->view(), simulator->mocap_pose(), true);
    }
    return recorder.take();
  }
  /// Expects all arrays of the recording.
  static void expect_recorded(const std::string& written, const Recording& expected) {
    EXPECT_EQ(read_file(written), recording_to_npz(expected));
  }

  static SensorModelPtr model_;
  test::TempFolder folder_;
};
SensorModelPtr ThreadRecording::model_;

TEST_F(ThreadRecording, RecordsTheHistoryLikeAPlainLoop) {
  ask(StepCommand{260});
  const auto all = result<RecordingWritten>(ExportHistoryCommand{file("all.npz")});
  EXPECT_EQ(all.error, "");
  EXPECT_EQ(all.rows, 260U) << "not the look before the first step";
  const Recording expected = plain(1, 260);
  EXPECT_GT(expected.rows.back().sensors[0].polygons, 0) << "in contact";
  EXPECT_NE(expected.rows.back().sensors[0].shear[3], dvec2(0));
  expect_recorded(file("all.npz"), expected);
  ask(ExportHistoryCommand{file("part.npz"), StepRange{100, 200}});
  expect_recorded(file("part.npz"), plain(100, 200));
  const auto none = result<RecordingWritten>(ExportHistoryCommand{file("none.npz"), StepRange{900, 901}});
  EXPECT_NE(none.error.find("no step there"), std::string::npos);
  EXPECT_FALSE(fs::exists(file("none.npz")));
}

TEST_F(ThreadRecording, KeepsEveryStepForAnyLengthOfTheHistory) {
  ask(StepHistoryLimitsCommand{{20, std::size_t{1} << 30}});
  ask(StepCommand{50});
  EXPECT_TRUE(ask(RecordCommand{file("live")})->recording.on);
  const SimFramePtr on = ask(StepCommand{150});
  EXPECT_EQ(on->recording.steps, 150U);
  EXPECT_NEAR(on->recording.seconds, 0.15, 1e-12);
  EXPECT_FALSE(fs::exists(file("live"))) << "nothing half written";
  EXPECT_FALSE(ask(EndRecordingCommand{})->recording.on);
  ASSERT_NE(test::newest<RecordingWritten>(events_), nullptr);
  EXPECT_EQ(test::newest<RecordingWritten>(events_)->error, "");
  expect_recorded(file("live/readings.npz"), plain(51, 200));
  EXPECT_TRUE(fs::exists(file("live/scene.xml")));
  EXPECT_TRUE(fs::exists(file("live/shear.csv")) && fs::exists(file("live/calibrated.csv")));
}

// Error bars of a recording and of the exported history are those of a plain loop, also after going back.
TEST_F(ThreadRecording, HasErrorBarsOnRequest) {
  const auto simulator = Simulator::make_scenario(model_, touching());
  RunRecorder recorder(*simulator->scene(), std::make_shared<ErrorBars>(simulator->scene()));
  for (int step = 1; step <= 130; ++step) {
    simulator->step();
    if (step > 100) recorder.follow(simulator->view(), simulator->mocap_pose(), true);
  }
  const Recording expected = recorder.take();
  double largest = 0;
  for (const RecordedRow& row : expected.rows)
    for (const double bar : row.sensors[0].errors) largest = std::max(largest, bar);
  EXPECT_GT(largest, 0);
  ask(StepCommand{100});
  ask(RecordCommand{file("live"), true});
  ask(StepCommand{40});
  ask(ScrubCommand{120});
  ask(StepCommand{10});
  ask(EndRecordingCommand{});
  expect_recorded(file("live/readings.npz"), expected);
  EXPECT_NE(read_file(file("live/readings.csv")).find(",taxel_0_error,"), std::string::npos);
  ask(ExportHistoryCommand{file("again.npz"), StepRange{101, 130}, true});
  expect_recorded(file("again.npz"), expected);
  ask(ExportHistoryCommand{file("plain.npz"), StepRange{101, 130}});
  EXPECT_FALSE(read_recording(file("plain.npz")).sensors[0].errors);
}

// A layout whose rays have no integral is recorded without error bars.
TEST_F(ThreadRecording, IsMadeWithoutErrorBarsIfThereAreNone) {
  Layout layout = model_->layout;
  layout.readout.ray = RayDirection::taxel_normal;
  ask(LoadScenarioCommand{build_sensor_model(layout, model_->mesh, "", "along taxels"), touching()});
  ask(RecordCommand{file("none.npz"), true});
  ask(StepCommand{5});
  EXPECT_EQ(result<RecordingWritten>(EndRecordingCommand{}).rows, 5U);
  EXPECT_FALSE(read_recording(file("none.npz")).sensors[0].errors);
}

TEST_F(ThreadRecording, RemovesLaterStepsWhenGoingBack) {
  ask(StepCommand{100});
  ask(RecordCommand{file("back.npz")});
  ask(StepCommand{100});
  ask(ScrubCommand{150});
  ask(StepCommand{40});
  EXPECT_EQ(ask(StepCommand{10})->recording.steps, 100U);
  ask(EndRecordingCommand{});
  expect_recorded(file("back.npz"), plain(101, 200));
  ask(RecordCommand{file("before.npz")});
  ask(StepCommand{10});
  ask(ScrubCommand{180});  // before the recording began
  ask(StepCommand{20});
  ask(EndRecordingCommand{});
  expect_recorded(file("before.npz"), [] {
    Recording expected = plain(181, 200);
    return expected;
  }());
}

TEST_F(ThreadRecording, EndsWithTheRun) {
  ask(RecordCommand{file("run.npz")});
  ask(StepCommand{30});
  EXPECT_FALSE(ask(ResetCommand{})->recording.on);
  ASSERT_NE(test::newest<RecordingWritten>(events_), nullptr);
  EXPECT_EQ(test::newest<RecordingWritten>(events_)->note, "it ended because the run was restarted");
  expect_recorded(file("run.npz"), plain(1, 30));
  ask(RecordCommand{file("none.npz")});
  EXPECT_NE(result<RecordingWritten>(EndRecordingCommand{}).error.find("no step was made"), std::string::npos);
  EXPECT_FALSE(fs::exists(file("none.npz")));
}

TEST_F(ThreadRecording, KeepsUnwritableRecordingsAndWritesThemElsewhere) {
  ask(RecordCommand{"/proc/no/live"});
  ask(StepCommand{30});
  const auto failed = result<RecordingWritten>(EndRecordingCommand{});
  EXPECT_NE(failed.error.find("/proc/no/live"), std::string::npos);
  EXPECT_TRUE(failed.kept);
  EXPECT_TRUE(result<RecordingWritten>(WriteRecordingCommand{"/proc/no/again.csv"}).kept);
  EXPECT_EQ(events_.size(), 1U) << "reported once each";
  const auto written = result<RecordingWritten>(WriteRecordingCommand{file("live.csv")});
  EXPECT_EQ(written.error, "");
  EXPECT_FALSE(written.file.empty());
  EXPECT_EQ(read_file(file("live.csv")), recording_to_csv(plain(1, 30)));
  ask(WriteRecordingCommand{file("once more.csv")});
  EXPECT_EQ(test::newest<RecordingWritten>(events_), nullptr) << "there is nothing left";
}

TEST_F(ThreadRecording, RecordsTheReadingsOfOneLayoutOnly) {
  ask(StepCommand{20});
  Layout layout = model_->layout;
  layout.calibration.reset();
  layout.readout.shear = false;
  const SensorModelPtr other = build_sensor_model(layout, model_->mesh, "", "other");
  ask(RecordCommand{file("first.npz")});
  ask(StepCommand{10});
  const auto first = result<RecordingWritten>(ReplaceModelCommand{model_, other});
  EXPECT_EQ(first.note, "it ended because another layout reads from there on");
  expect_recorded(file("first.npz"), plain(21, 30));
  ask(StepCommand{10});
  const auto second = result<RecordingWritten>(ExportHistoryCommand{file("second.npz")});
  EXPECT_EQ(second.rows, 11U) << "the newest step is read again";
  EXPECT_EQ(second.note, "29 earlier steps were read by another layout and are left out");
  EXPECT_FALSE(read_recording(file("second.npz")).sensors[0].shear);
}

}  // namespace
}  // namespace taxel
