// Batches whose results change between two calls, and calls that end while the index is moved to its place.
#include "core/sim/batch/run_batch.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/shard.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

const std::string kTwoPresses =
    R"({"layout": ")" TAXEL_SOURCE_DIR R"(/assets/layouts/fingertip.taxels.json", "scenario": {"kind": "press"}, )"
    R"("set": {"/scenario/depth": {"values": [0.0004, 0.0006]}}})";

/// A batch of one group, whose shard is made here.
class ChangingBatch : public testing::Test {
 protected:
  /// Runs the batch. The jobs of a group fail with `error`, or have one row if it is empty. `on_group` is called before
  /// the shard is made.
  void run(
      const std::string& error, const std::function<void()>& on_group = [] {}) {
    BatchSettings settings;
    settings.folder = root_;
    settings.npz = npz_;
    settings.run_group = [&](const JobGroup& group, const JobWatch& /*watch*/) {
      on_group();
      return shard_bytes(result_of(group, error), {});
    };
    run_batch(list_, sources_, settings, {});
  }
  void remove_shard() const { fs::remove(root_ / shard_name(group_jobs(list_, 16).front().id)); }

  TempFolder folder_;
  fs::path root_ = folder_ / "batch";
  bool npz_ = false;

 private:
  [[nodiscard]] GroupResult result_of(const JobGroup& group, const std::string& error) const {
    GroupResult result;
    result.head.group = group.id;
    for (const std::size_t job : group.jobs) {
      JobOutcome& outcome = result.head.outcomes.emplace_back();
      outcome.id = list_.jobs[job].id;
      outcome.error = error;
      if (!error.empty()) continue;
      outcome.rows = 1;
      result.episodes.push_back({1, {{kTimestamp, 1, false, {0}}, {kTactile, 1, true, {2}}}, {}});
      result.head.sensor = EpisodeSensor{"key", "{}", "finger", {0}, {"tip"}, "Pa", ""};
    }
    return result;
  }

  JobSources sources_;
  JobList list_ = parse_job_list(kTwoPresses, "jobs.jsonl", "/", sources_);
};

TEST_F(ChangingBatch, HasNoHeadWhileAGroupRunsAgain) {
  run("the worker ended");
  EXPECT_EQ(read_batch_index(root_).failed.size(), 2U);
  remove_shard();
  bool had_head = true;
  run("", [&] { had_head = fs::exists(root_ / kBatchFile); });
  EXPECT_FALSE(had_head) << "its rows would be looked up in another shard";
  EXPECT_EQ(read_batch_index(root_).episodes.size(), 2U);
  EXPECT_FALSE(fs::exists(root_ / "failed.jsonl"));
}

TEST_F(ChangingBatch, ContinuesIfItsIndexWasNotReplaced) {
  run("the worker ended");
  remove_shard();
  const auto block = [&] {
    fs::remove(root_ / "summary.csv");
    fs::create_directory(root_ / "summary.csv");
  };
  EXPECT_THROW(run("", block), Error) << "a folder has the place of a file";
  EXPECT_TRUE(fs::exists(root_ / "failed.jsonl")) << "nothing was moved";
  fs::remove(root_ / "summary.csv");
  run("not called");
  EXPECT_EQ(read_batch_index(root_).episodes.size(), 2U);
  EXPECT_EQ(read_batch_index(root_).failed.size(), 0U);
  const std::string journal = read_file(root_ / ".batch/journal");
  run("not called");
  EXPECT_EQ(read_file(root_ / ".batch/journal"), journal) << "the batch is complete";
}

TEST_F(ChangingBatch, IsCompleteWithoutRecordingsIfAllJobsFailed) {
  npz_ = true;
  run("the worker ended");
  const std::string journal = read_file(root_ / ".batch/journal");
  run("not called");
  EXPECT_EQ(read_file(root_ / ".batch/journal"), journal);
}

}  // namespace
}  // namespace taxel::test
