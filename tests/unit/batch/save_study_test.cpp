// Studies as batches: a study that is written and read again has the runs of the study, bit for bit; batches that are
// no study are refused.
#include "core/sim/study.h"

#include <gtest/gtest.h>

#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"
#include "core/run/batch/batch_index.h"
#include "core/run/batch/study_of_batch.h"
#include "core/sim/batch/run_batch.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

constexpr const char* kLayout = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";
constexpr const char* kShortPress =
    R"({"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"})";

/// Our fingertip with few samples.
SensorSource coarse_source() {
  SensorSource source = read_sensor_source(kLayout);
  source.layout.sampling.density = 1e5;
  return source;
}

StudyCurves read_back(const std::filesystem::path& folder) {
  Progress progress;
  return read_study_of_batch(folder, progress);
}

/// Returns times and readings of all runs as the simulator gives them.
std::vector<StudyCurve> simulated(const Study& study, const SensorModel& model) {
  const std::vector<StudyRun> runs = runs_of(study);
  std::vector<StudyCurve> curves(runs.size());
  const auto model_of = [&](std::size_t run) {
    Layout layout = model.layout;
    layout.sampling.density = runs[run].density.value_or(layout.sampling.density);
    layout.sampling.seed = runs[run].seed.value_or(layout.sampling.seed);
    return build_sensor_model(layout, model.loaded, "", "study");
  };
  const auto on_step = [&](std::size_t run, const Simulator& simulator) {
    if (!simulator.row_due()) return true;
    const StepView step = simulator.view();
    curves[run].time.push_back(step.time);
    curves[run].readings.resize(step.sensors.front().readings.size());
    for (std::size_t k = 0; k < curves[run].readings.size(); ++k)
      curves[run].readings[k].push_back(step.sensors.front().readings[k]);
    return true;
  };
  Progress progress;
  run_study(
      runs, model_of, on_step, [&](std::size_t run, const std::string& error) { curves[run].error = error; }, progress);
  return curves;
}

class StudyFolder : public testing::Test {
 protected:
  StudyToSave study_to_save(std::vector<StudyParameter> parameters) {
    return {{parse_scenario(kShortPress), std::move(parameters)},
            build_sensor_model(coarse_source()),
            folder_ / "study",
            "taxel test"};
  }
  static BatchCounts save(const StudyToSave& what) {
    Progress progress;
    return save_study(what, progress);
  }
  /// Runs a line of a list of jobs.
  std::filesystem::path batch(const std::string& set, const std::string& more = "") const {
    const std::string line = "{\"layout\": \"" + std::string(kLayout) + "\", \"scenario\": " + kShortPress +
                             ", \"set\": {" + set + "}" + more + "}";
    JobSources sources;
    BatchSettings settings;
    settings.folder = folder_ / "batch";
    run_batch(parse_job_list(line, "jobs", folder_ / "", sources), sources, settings, {});
    return settings.folder;
  }
  std::string refusal(const std::string& set, const std::string& more = "") const {
    const std::filesystem::path folder = batch(set, more);
    std::string complaint = complaint_of([&] { read_back(folder); });
    std::filesystem::remove_all(folder);
    const std::string file = folder.string() + ": ";
    return complaint.starts_with(file) ? complaint.substr(file.size()) : "another file: " + complaint;
  }

  TempFolder folder_;
};

TEST_F(StudyFolder, HasTheRunsOfTheStudyBitForBit) {
  const StudyToSave what = study_to_save({{"depth", {0.0004, 0.0008}}, {"seed", {1, 2, 3}}});
  EXPECT_EQ(save(what).episodes, 6);
  const StudyCurves read = read_back(what.folder);
  EXPECT_EQ(read.study.parameters, (std::vector<StudyParameter>{{"seed", {1, 2, 3}}, {"depth", {0.0004, 0.0008}}}))
      << "in the order of their pointers";
  ASSERT_EQ(read.runs.size(), 6U);
  const std::vector<StudyCurve> expected = simulated(read.study, *what.model);
  for (std::size_t i = 0; i < read.runs.size(); ++i) {
    EXPECT_EQ(read.runs[i].time, expected[i].time);
    EXPECT_EQ(read.runs[i].readings, expected[i].readings);
    EXPECT_FALSE(read.runs[i].time.empty());
  }
  EXPECT_EQ(read.taxel_ids.size(), what.model->layout.taxels.size());
  EXPECT_GT(read.largest_reading, 0);
  EXPECT_EQ(read.folder, what.folder.string());
}

TEST_F(StudyFolder, KeepsTheReasonOfAFailedRun) {
  const StudyToSave what = study_to_save({{"finger_mass", {1e-15, 0.02}}});
  const BatchCounts counts = save(what);
  EXPECT_EQ(counts.episodes, 1);
  EXPECT_EQ(counts.failed.size(), 1U);
  const StudyCurves read = read_back(what.folder);
  EXPECT_NE(read.runs[0].error.find("inertia"), std::string::npos) << read.runs[0].error;
  EXPECT_TRUE(read.runs[0].time.empty());
  EXPECT_EQ(read.runs[1].error, "");
}

TEST_F(StudyFolder, RefusesAFolderWithSomethingElse) {
  StudyToSave what = study_to_save({{"depth", {0.0004}}});
  save(what);
  EXPECT_EQ(complaint_of([&] { save(what); }), what.folder.string() + ": has the batch of this study already");
  what.study.parameters = {{"depth", {0.0005}}};
  EXPECT_NE(complaint_of([&] { save(what); }).find("belongs to another batch"), std::string::npos);
  EXPECT_EQ(read_back(what.folder).runs.size(), 1U) << "it stays";
}

TEST_F(StudyFolder, RefusesTimesThatAreNoSingleNumbers) {
  const StudyToSave what = study_to_save({{"depth", {0.0004}}});
  save(what);
  const std::filesystem::path file = what.folder / read_batch_index(what.folder).episodes.front().shard;
  for (const std::size_t width : {0U, 2U}) {
    GroupResult result;
    result.head = Shard(file).head();
    result.head.columns.clear();
    Episode& episode = result.episodes.emplace_back();
    episode.rows = result.head.outcomes.front().rows;
    episode.columns = {{kTimestamp, width, true, std::vector<double>(static_cast<std::size_t>(episode.rows) * width)}};
    write_file_atomically(file, shard_bytes(result, {.float64 = true}));
    EXPECT_EQ(complaint_of([&] { read_back(what.folder); }),
              file.string() + ": timestamp: is damaged: it must have one number in each row");
  }
}

TEST_F(StudyFolder, ContinuesAfterACancelledCall) {
  const StudyToSave what = study_to_save({{"depth", {0.0004, 0.0005}}});
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(save_study(what, cancelled), Cancelled);
  EXPECT_EQ(save(what).episodes, 2);
}

TEST_F(StudyFolder, OpensListsOfJobsWithOneOrTwoNumbers) {
  const StudyCurves read = read_back(batch(
      R"("/layout/sampling/density": {"values": [2e5, 1e5]}, "/scenario/depth": {"from": 0.0004, "to": 0.0006, "count": 3}, )"
      R"("/layout/sampling/seed": 5)"));
  EXPECT_EQ(read.study.parameters,
            (std::vector<StudyParameter>{{"density", {1e5, 2e5}}, {"depth", {0.0004, 0.0005, 0.0006}}}));
  EXPECT_EQ(read.runs[5].run.density, 2e5);
  EXPECT_EQ(read.runs[5].run.scenario.as<scenarios::Press>().depth, 0.0006);
}

TEST_F(StudyFolder, RefusesBatchesThatAreNoStudy) {
  const std::string density = R"("/layout/sampling/density": 1e5, )";
  EXPECT_EQ(
      refusal(R"("/layout/sampling/density": {"values": [1e5, 2e5]}, "/scenario/depth": {"values": [4e-4, 5e-4]},)"
              R"("/scenario/tilt_deg": {"values": [20, 30]})"),
      "is no study: one or two numbers must vary, and 3 do (/layout/sampling/density, /scenario/depth, "
      "/scenario/tilt_deg)");
  EXPECT_EQ(refusal(density + R"("/scenario/shape": {"values": ["plate", "box"]})"),
            "is no study: its jobs change several sets of values, or values that are no numbers");
  EXPECT_EQ(refusal(density + R"("/layout/material/modulus": {"values": [3e4, 5e4]})"),
            "/layout/material/modulus: is no parameter of a study");
  const std::string random = refusal(R"("/layout/sampling/density": {"values": [1e5, 2e5]}, )"
                                     R"("/scenario/depth": {"uniform": [4e-4, 5e-4]})");
  EXPECT_NE(random.find("is no study: no run with /layout/sampling/density = 100000, "), std::string::npos) << random;
  const std::string twice = refusal(density + R"("/scenario/depth": {"values": [4e-4, 5e-4]})", R"(, "repeat": 2)");
  EXPECT_NE(twice.find("is no study: several runs with "), std::string::npos) << twice;
}

}  // namespace
}  // namespace taxel::test
