// The rows of a recording on disk while the recording runs: complete and with the same numbers after a kill at any
// time.
#include "core/sim/host/recording_journal.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/base/files.h"
#include "core/run/recording/recording_files.h"
#include "core/sim/compare/error_bars.h"
#include "core/sim/host/sim_recordings.h"
#include "core/sim/simulator.h"
#include "fixtures/asked_sim.h"
#include "fixtures/box_sweep.h"
#include "fixtures/ended_process.h"
#include "fixtures/run_program.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Returns a scenario that is in contact after a few steps.
Scenario touching() {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = 0.002;
  scenario.as<scenarios::Sweep>().speed = 0.02;
  return scenario;
}

class Journal : public testing::Test, protected test::AskedSim {
 protected:
  static void SetUpTestSuite() {
    const fs::path file = fs::path(TAXEL_SOURCE_DIR) / "assets/layouts/fingertip.taxels.json";
    Layout layout = read_layout(file);
    layout.sampling.density = 1e5;
    layout.readout.shear = true;
    const LoadedMesh mesh = load_mesh(mesh_path(layout, file), layout.mesh.scale);
    plain_ = build_sensor_model(layout, mesh.mesh, mesh.sha256, file.string());
    layout.calibration.emplace();
    model_ = build_sensor_model(layout, mesh.mesh, mesh.sha256, file.string());
  }
  static void TearDownTestSuite() { model_.reset(), plain_.reset(); }
  [[nodiscard]] fs::path base() const { return folder_.path() / "1-1"; }

  /// Follows `steps` steps, of which every `every`-th becomes a row, into recorder and journal.
  void follow(RunRecorder& recorder, RecordingJournal& journal, int steps, int every) {
    const auto simulator = Simulator::make_scenario(in_use_, touching());
    for (int step = 0; step < steps; ++step) {
      simulator->step();
      recorder.follow(simulator->view(), simulator->mocap_pose(), step % every == every - 1);
      journal.follow(recorder.recording());
    }
  }
  [[nodiscard]] std::shared_ptr<const SimScene> scene() const {
    return Simulator::make_scenario(in_use_, touching())->scene();
  }
  static SensorModelPtr model_, plain_;  ///< `model_` is calibrated and has shear, `plain_` has shear
  SensorModelPtr in_use_ = model_;
  test::TempFolder folder_;
};
SensorModelPtr Journal::model_, Journal::plain_;

TEST_F(Journal, ReadsBackTheSameNumbers) {
  for (const int every : {1, 4}) {
    const auto recorded = scene();
    RunRecorder recorder(*recorded, std::make_shared<ErrorBars>(recorded));
    auto journal = std::make_unique<RecordingJournal>(base(), "/somewhere/recording-1");
    follow(recorder, *journal, 60, every);
    EXPECT_FALSE(read_recording_journal(base())) << "its process lives";
    journal.reset();
    const std::optional<LeftRecording> left = read_recording_journal(base());
    ASSERT_TRUE(left);
    EXPECT_EQ(left->target, "/somewhere/recording-1");
    EXPECT_EQ(recording_to_npz(left->recording), recording_to_npz(recorder.recording())) << every;
  }
}

TEST_F(Journal, ReadsFilesOfVersionsWithoutTheElasticForce) {
  RunRecorder recorder(*scene());
  {
    RecordingJournal unused(folder_.path() / "unused", "x");
    follow(recorder, unused, 9, 1);
  }
  Recording recording = recorder.recording();
  for (RecordedRow& row : recording.rows)
    for (SensorRecord& sensor : row.sensors) sensor.elastic_force_W.reset();
  {
    RecordingJournal journal(base(), "x");
    journal.follow(recording);
  }
  const fs::path rows = base().string() + ".rows";
  std::string bytes = read_file(rows);
  bytes[bytes.find('\n') - 1] = '1';
  write_file_atomically(rows, bytes);
  EXPECT_EQ(recording_to_npz(read_recording_journal(base())->recording), recording_to_npz(recording));
}

TEST_F(Journal, DropsDiscardedSteps) {
  in_use_ = plain_;  // the runs below begin again at 0 s, which a calibration refuses
  RunRecorder recorder(*scene());
  {
    RecordingJournal journal(base(), "x");
    follow(recorder, journal, 30, 1);
    recorder.cut_after(20);
    journal.cut_to(recorder.recording());
    follow(recorder, journal, 5, 1);
    recorder.cut_after(0);
    journal.cut_to(recorder.recording());
    follow(recorder, journal, 7, 1);
  }
  ASSERT_EQ(recorder.recording().rows.size(), 7U);
  EXPECT_EQ(recording_to_npz(read_recording_journal(base())->recording), recording_to_npz(recorder.recording()));
}

// A killed process leaves the beginning of the file, up to any byte.
TEST_F(Journal, KeepsEveryCompleteRowOfAFileCutAnywhere) {
  RunRecorder recorder(*scene());
  {
    RecordingJournal journal(base(), "x");
    follow(recorder, journal, 12, 1);
  }
  const fs::path rows = base().string() + ".rows";
  const std::string whole = read_file(rows);
  const std::size_t begin = whole.find('\n', whole.find('\n') + 1) + 1, entry = (whole.size() - begin) / 11;
  ASSERT_EQ(begin + 11 * entry, whole.size()) << "the first row is in the head";
  for (std::size_t size = begin; size <= whole.size(); size += 19) {
    test::write_text(rows, whole.substr(0, size));
    const std::optional<LeftRecording> left = read_recording_journal(base());
    ASSERT_TRUE(left) << size;
    EXPECT_EQ(left->recording.rows.size(), 1 + (size - begin) / entry) << size;
    EXPECT_EQ(left->recording.mocap.size(), left->recording.rows.size());
  }
  for (std::size_t at = begin + 5 * entry; at < begin + 6 * entry; at += 31) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    test::write_text(rows, flipped);
    EXPECT_EQ(read_recording_journal(base())->recording.rows.size(), 6U) << "byte " << at;
  }
}

TEST_F(Journal, ClearsJournalsWithoutRowsAndIgnoresOtherFiles) {
  { RecordingJournal journal(base(), "x"); }
  test::write_text(folder_.path() / "2-1.rows", "no journal");
  test::write_text(folder_.path() / "2-1.npz", "no archive");
  EXPECT_TRUE(left_recordings(folder_.path()).empty());
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  EXPECT_TRUE(left_recordings(folder_.path() / "absent").empty());
}

TEST_F(Journal, IsConvertedToItsRecording) {
  const fs::path target = folder_.path() / "recording-1";
  for (const char* name : {"recording-1", "recording-1-recovered", "recording-1-recovered-2"}) {
    RunRecorder recorder(*scene());
    {
      RecordingJournal journal(base(), target.string());
      follow(recorder, journal, 5, 1);
    }
    EXPECT_EQ(write_left_recording(*read_recording_journal(base())), folder_.path() / name);
    EXPECT_EQ(read_file(folder_.path() / name / "readings.npz"), recording_to_npz(recorder.recording()));
    EXPECT_TRUE(left_recordings(folder_.path()).empty());
  }
}

// A process that is killed while it writes the recording leaves a folder with a temporary one inside.
TEST_F(Journal, ReplacesOrClearsAnUnfinishedTarget) {
  const fs::path target = folder_.path() / "recording-1",
                 part = target / (".taxel-" + std::to_string(test::ended_process()) + "-0123abcd.part");
  for (const bool wanted : {false, true}) {
    fs::create_directories(part);
    test::write_text(part / "readings.csv", "half");
    RunRecorder recorder(*scene());
    {
      RecordingJournal journal(base(), target.string());
      follow(recorder, journal, 5, 1);
    }
    const LeftRecording left = *read_recording_journal(base());
    if (wanted) {
      EXPECT_EQ(write_left_recording(left), target);
      EXPECT_EQ(read_recording(target).rows.size(), 5U);
      EXPECT_FALSE(fs::exists(part));
    } else {
      discard_left_recording(left);
      EXPECT_TRUE(fs::is_empty(folder_.path()));
    }
  }
}

// A process that is killed while it puts the files of the recording in place leaves some of them, and the temporary
// folder of the others.
TEST_F(Journal, KeepsFilesOfAnUnfinishedTargetButNotItsParts) {
  const fs::path target = folder_.path() / "recording-1",
                 part = target / (".taxel-" + std::to_string(test::ended_process()) + "-0123abcd.part");
  for (const bool wanted : {false, true}) {
    fs::create_directories(part);
    test::write_text(part / "readings.npz", "other half");
    test::write_text(target / "readings.csv", "half");
    RunRecorder recorder(*scene());
    {
      RecordingJournal journal(base(), target.string());
      follow(recorder, journal, 5, 1);
    }
    const LeftRecording left = *read_recording_journal(base());
    if (wanted)
      EXPECT_EQ(write_left_recording(left), folder_.path() / "recording-1-recovered");
    else
      discard_left_recording(left);
    EXPECT_FALSE(fs::exists(part)) << wanted;
    EXPECT_EQ(read_file(target / "readings.csv"), "half");
  }
}

TEST_F(Journal, ExistsAsLongAsTheRecordingOfTheThread) {
  const fs::path journals = folder_.path() / "journals";
  sim_.set_journal_folder(journals.string());
  ask(LoadScenarioCommand{model_, touching()});
  ask(RecordCommand{(folder_.path() / "out").string()});
  ask(StepCommand{20});
  fs::path rows;
  for (const auto& entry : fs::directory_iterator(journals))
    if (entry.path().extension() == ".rows") rows = entry.path();
  ASSERT_FALSE(rows.empty());
  const fs::path copy = folder_.path() / "copy";  // as a killed process would leave it
  fs::copy_file(rows, copy.string() + ".rows");
  fs::copy_file(fs::path(rows).replace_extension(".npz"), copy.string() + ".npz");
  ask(EndRecordingCommand{});
  EXPECT_TRUE(fs::is_empty(journals)) << "the recording is written";
  EXPECT_EQ(recording_to_npz(read_recording_journal(copy)->recording), read_file(folder_.path() / "out/readings.npz"));
}

TEST_F(Journal, WarnsIfUnwritableAndTheRecordingContinues) {
  test::write_text(folder_.path() / "journals", "a file");
  sim_.set_journal_folder((folder_.path() / "journals").string());
  ask(LoadScenarioCommand{model_, touching()});
  const Warned warned = result<Warned>(RecordCommand{(folder_.path() / "out").string()});
  EXPECT_NE(warned.text.find("The recording is in memory only"), std::string::npos) << warned.text;
  ask(StepCommand{5});
  ask(EndRecordingCommand{});
  EXPECT_EQ(read_recording(folder_.path() / "out").rows.size(), 5U);
}

}  // namespace
}  // namespace taxel
