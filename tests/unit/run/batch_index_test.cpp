// Batches: shards, the index that is written from them and read again, and damaged ones.
#include "core/run/batch/batch_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/files.h"
#include "core/base/rng.h"
#include "core/document/batch/job.h"
#include "core/document/scenario/scenario.h"
#include "core/run/batch/batch_folder.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

/// Returns an episode with `taxels` readings in each of `rows` rows.
Episode made_episode(std::int64_t rows, std::size_t taxels, std::uint64_t seed, bool has_shear) {
  const CounterRng rng(seed);
  Episode episode{rows, {}, {1.5 + static_cast<double>(seed), 3, 2, 0.01 * static_cast<double>(rows - 1)}};
  std::uint64_t next = 0;
  const auto add = [&](const char* name, std::size_t width, bool is_list) {
    EpisodeColumn column{name, width, is_list, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows) * width; ++i)
      column.values.push_back(rng.uniform(next++) - 0.5);
    episode.columns.push_back(std::move(column));
  };
  add(kTimestamp, 1, false), add(kTravel, 1, false), add(kTactile, taxels, true), add(kContactForce, 3, true);
  if (has_shear) add(kShear, 2 * taxels, true);
  return episode;
}

/// A batch of seven jobs of two layouts; the fourth job fails, and the last has no valid content.
class MadeBatch {
 public:
  explicit MadeBatch(const TempFolder& folder, std::size_t second_taxels = 3, bool has_shear = false,
                     std::string second_name = "tip")
      : second_name_(std::move(second_name)), folder_(folder / "batch") {
    make_folder(folder_ / "shards");
    for (int i = 0; i < 7; ++i) {
      Job job;
      job.line = i + 1;
      job.id = "job" + std::to_string(i);
      job.seed = static_cast<std::uint64_t>(100 + i);
      job.layout_key = i % 2 == 0 ? "even" : "odd";
      job.task = i < 4 ? "press" : "slide, \"fast\"";
      job.changes = {{"/scenario/depth", "0.00" + std::to_string(i)}};
      if (i == 6) job.error = "/scenario/depth: must be greater than 0, is -1";
      list_.jobs.push_back(job);
    }
    list_.broken.push_back({9, "is not JSON"});
    list_.sha256 = "list";
    groups_ = group_jobs(list_, 2);
    for (const JobGroup& group : groups_) write_shard(group, second_taxels, has_shear);
  }
  [[nodiscard]] BatchPlan plan() const { return {list_, groups_, folder_, format_, "taxel test"}; }
  [[nodiscard]] const Episode& episode(const std::string& job) const { return episodes_.at(job); }

 private:
  void write_shard(const JobGroup& group, std::size_t second_taxels, bool has_shear) {
    GroupResult result;
    result.head.group = group.id;
    for (const std::size_t i : group.jobs) {
      const Job& job = list_.jobs[i];
      const bool is_odd = job.layout_key == "odd";
      const std::size_t taxels = is_odd ? second_taxels : 3;
      JobOutcome& outcome = result.head.outcomes.emplace_back();
      outcome.id = job.id;
      if (i == 3) {
        outcome.error = "the simulation became unstable";
        continue;
      }
      episodes_[job.id] = made_episode(4 + static_cast<std::int64_t>(i), taxels, i, has_shear && is_odd);
      result.episodes.push_back(episodes_[job.id]);
      outcome.rows = result.episodes.back().rows;
      outcome.summary = result.episodes.back().summary;
      std::vector<std::int64_t> ids(taxels);
      std::vector<std::string> names(taxels, is_odd ? second_name_ : "tip");
      for (std::size_t k = 0; k < taxels; ++k) ids[k] = static_cast<std::int64_t>(k);
      result.head.sensor = EpisodeSensor{job.layout_key, "{}", "finger", ids, names, "Pa", ""};
    }
    write_file_atomically(folder_ / shard_name(group.id), shard_bytes(result, format_));
  }

  JobList list_;
  std::vector<JobGroup> groups_;
  std::string second_name_;  // of the taxels of the second layout
  std::filesystem::path folder_;
  BatchFormat format_{true, false, 2};
  std::map<std::string, Episode> episodes_;
};

/// Writes the index into the folder of the batch.
BatchCounts write(const MadeBatch& batch) {
  return write_batch_index(batch.plan().folder, batch.plan(), [](double) {});
}

TEST(JobGroups, HaveOneLayoutAndLeaveOutBrokenJobs) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  std::vector<std::vector<std::size_t>> jobs;
  for (const JobGroup& group : batch.plan().groups) jobs.push_back(group.jobs);
  EXPECT_EQ(jobs, (std::vector<std::vector<std::size_t>>{{0, 2}, {4}, {1, 3}, {5}}));
}

TEST(BatchIndex, HasTheEpisodesOfAllShards) {
  const TempFolder folder;
  const MadeBatch batch(folder, 5, true);
  const BatchCounts counts = write(batch);
  EXPECT_EQ(counts.episodes, 5);
  EXPECT_EQ(counts.frames, 4 + 6 + 8 + 5 + 9);
  ASSERT_EQ(counts.failed.size(), 2U);
  EXPECT_EQ(counts.failed[0].error, "the simulation became unstable");
  EXPECT_EQ(counts.failed[1].line, 7);
  const BatchIndex index = read_batch_index(batch.plan().folder);
  EXPECT_EQ(index.program, "taxel test");
  EXPECT_EQ(index.bits, 64);
  EXPECT_EQ(index.failed, counts.failed);
  ASSERT_EQ(index.broken.size(), 1U);
  EXPECT_EQ(index.broken[0].line, 9);
  EXPECT_EQ(index.broken[0].message, "is not JSON");
  std::vector<std::string> jobs;
  for (const EpisodeEntry& entry : index.episodes) {
    jobs.push_back(entry.job);
    const Episode& made = batch.episode(entry.job);
    EXPECT_EQ(entry.rows, made.rows);
    EXPECT_EQ(entry.summary, made.summary);
    const Shard shard(batch.plan().folder / entry.shard);
    for (const EpisodeColumn& column : made.columns) {
      const EpisodeColumn read = shard.rows(column.name, entry.first_row, entry.rows);
      EXPECT_EQ(read.values, column.values) << column.name;
      EXPECT_EQ(read.width, column.width);
      EXPECT_EQ(read.is_list, column.is_list);
    }
  }
  EXPECT_EQ(jobs, (std::vector<std::string>{"job0", "job2", "job4", "job1", "job5"}));
  EXPECT_EQ(index.episodes[4].task, "slide, \"fast\"");
  EXPECT_EQ(index.episodes[4].seed, 105U);
  EXPECT_EQ(index.episodes[4].changes, (std::vector<JobChange>{{"/scenario/depth", "0.005"}}));
  EXPECT_EQ(parse_scenario(index.episodes[4].scenario, "episode"), Scenario());
  EXPECT_EQ(index.layouts[index.episodes[4].layout].layout_key, "odd");
  EXPECT_EQ(index.layouts[index.episodes[4].layout].taxel_ids.size(), 5U);
}

TEST(BatchIndex, HasASummaryForTables) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch);
  const std::string summary = read_file(batch.plan().folder / "summary.csv");
  EXPECT_TRUE(summary.starts_with("episode,line,number,seed,task,/scenario/depth,rows,duration,")) << summary;
  EXPECT_NE(summary.find("\n2,5,0,104,\"slide, \"\"fast\"\"\",0.004,8,0.07,5.5,3,2,job4\n"), std::string::npos)
      << summary;
}

TEST(Episode, IsResampledToWholeMultiplesOfTheInterval) {
  Episode episode;
  episode.rows = 4;
  episode.columns = {{kTimestamp, 1, false, {0, 0.013, 0.02, 0.0523}},
                     {kTactile, 2, true, {0, 1, 13, 0.987, 20, 0.98, 52.3, 0.9477}},
                     {kMocapPose, 7, true, {}}};
  for (const double sign : {1.0, -1.0, 1.0, 1.0})  // the same rotation with either sign
    for (const double value : {1.0, 2.0, 3.0, sign * 0.6, sign * 0.8, 0.0, 0.0})
      episode.columns[2].values.push_back(value);
  const Episode even = resampled(episode, 100);
  ASSERT_EQ(even.rows, 6);
  for (std::size_t row = 0; row < 6; ++row) {
    EXPECT_EQ(even.columns[0].values[row], static_cast<double>(row) / 100);
    EXPECT_NEAR(even.columns[1].values[2 * row], 10 * static_cast<double>(row), 1e-12) << "1000 times the time";
    EXPECT_NEAR(even.columns[1].values[2 * row + 1], 1 - 0.01 * static_cast<double>(row), 1e-12);
    EXPECT_NEAR(std::abs(even.columns[2].values[7 * row + 3]), 0.6, 1e-12);
    EXPECT_NEAR(std::abs(even.columns[2].values[7 * row + 4]), 0.8, 1e-12);
  }
  EXPECT_EQ(resampled(even, 100).columns[1].values, even.columns[1].values);
}

TEST(BatchIndex, IsNotWrittenFromShardsOfOtherJobs) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const BatchPlan plan = batch.plan();
  const auto path = [&](int i) { return plan.folder / shard_name(plan.groups[static_cast<std::size_t>(i)].id); };
  write_file_atomically(path(0), read_file(path(2)));
  int calls = 0;
  const auto complaint = [&] {
    const std::filesystem::path index = folder / ("index" + std::to_string(calls++));
    make_folder(index);
    return complaint_of([&] { write_batch_index(index, plan, [](double) {}); });
  };
  const std::string refusal = path(0).string() + ": has other jobs than its name says";
  EXPECT_EQ(complaint(), refusal);
  // Either the group or a job differs, or a job is missing.
  struct Case {
    std::string group;
    std::vector<std::string> jobs;
  };
  const std::string group = plan.groups[0].id;
  for (const Case& c : {Case{"other", {"job0", "job2"}}, {group, {"job0", "job1"}}, {group, {"job0"}}}) {
    GroupResult result;
    result.head.group = c.group;
    for (const std::string& job : c.jobs) result.head.outcomes.push_back({job, 0, {}, "unstable"});
    write_file_atomically(path(0), shard_bytes(result, plan.format));
    EXPECT_EQ(complaint(), refusal) << c.group;
  }
}

TEST(BatchIndex, IsNotWrittenFromOtherJobsUnderTheNameOfAGroup) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const JobGroup& group = batch.plan().groups[0];
  ShardHead head;
  head.group = group.id;
  for (const std::size_t job : group.jobs) head.outcomes.push_back({batch.plan().list.jobs[job].id, 3, {}, ""});
  const auto complaint = [&](const ShardHead& changed) {
    return complaint_of([&] { check_jobs(batch.plan().list, group, changed, "shard"); });
  };
  EXPECT_EQ(complaint(head), "accepted");
  ShardHead swapped = head, shorter = head, other = head;
  std::swap(swapped.outcomes[0], swapped.outcomes[1]);
  shorter.outcomes.pop_back();
  other.outcomes[1].id = "job5";
  for (const ShardHead& changed : {swapped, shorter, other})
    EXPECT_EQ(complaint(changed), "shard: has other jobs than its name says");
}

TEST(Shard, NamesTheArrayThatIsDamaged) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const std::filesystem::path path = batch.plan().folder / shard_name(batch.plan().groups[0].id);
  EXPECT_NO_THROW(Shard(path).check());
  std::string bytes = read_file(path);
  const std::size_t array = bytes.find(kContactForce);
  bytes[array + 60] ^= 1;
  write_file_atomically(path, bytes);
  const std::string complaint = complaint_of([&] { Shard(path).check(); });
  EXPECT_TRUE(complaint.starts_with(path.string() + ": observation.force: ")) << complaint;
  write_file_atomically(path, bytes.substr(0, bytes.size() / 2));
  EXPECT_TRUE(complaint_of([&] { Shard{path}; }).starts_with(path.string() + ": "));
}

TEST(Shard, HasNoRowsOutsideOfItsArrays) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const std::filesystem::path path = batch.plan().folder / shard_name(batch.plan().groups[0].id);
  const Shard shard(path);  // 4 and 6 rows
  const auto complaint = [&](const char* column, std::int64_t first, std::int64_t count) {
    return complaint_of([&] { static_cast<void>(shard.rows(column, first, count)); });
  };
  EXPECT_EQ(complaint(kTactile, 4, 6), "accepted");
  const std::string refusal = path.string() + ": observation.tactile: has not the rows that the list of episodes names";
  EXPECT_EQ(complaint(kTactile, 4, 7), refusal);
  EXPECT_EQ(complaint(kTactile, 11, 0), refusal);
  EXPECT_EQ(complaint(kTactile, -1, 2), refusal);
  EXPECT_EQ(complaint(kShear, 0, 1), path.string() + ": observation.shear: is missing");
}

// A skin that hardly touches anything has readings that pack a thousand times smaller.
TEST(Shard, IsReadIfNearlyAllReadingsAreZero) {
  GroupResult result;
  Episode& episode = result.episodes.emplace_back();
  constexpr std::int64_t kRows = 2000;
  constexpr std::size_t kTaxels = 10000;
  episode.rows = kRows;
  episode.columns = {{kTactile, kTaxels, true, std::vector<double>(kRows * kTaxels)}};
  episode.columns[0].values[7] = 1.5;
  result.head.group = "group";
  result.head.outcomes = {{"job", kRows, {}, ""}};
  const Shard shard(shard_bytes(result, {.float64 = true}), "shard");
  EXPECT_EQ(shard.rows(kTactile, 0, 1).values[7], 1.5);
}

TEST(Shard, TakesNoMemoryForASizeThatItsBytesCannotHave) {
  GroupResult result;
  result.head.group = "group";
  result.head.outcomes = {{"job", 1000, {}, ""}};
  result.episodes.push_back({1000, {{kTimestamp, 1, false, std::vector<double>(1000)}}, {}});
  std::string bytes = shard_bytes(result, {.float64 = true});
  EXPECT_NO_THROW(Shard(bytes, "shard").check());
  const std::string size("\xc0\x1f\0\0", 4);  // 8128, of 1000 numbers and their header of 128 bytes
  ASSERT_NE(bytes.find(size), std::string::npos);
  for (std::size_t at = bytes.find(size); at != std::string::npos; at = bytes.find(size, at + 4))
    bytes.replace(at, 4, "\xff\xff\xff\x7f");
  const std::string complaint = complaint_of([&] { Shard(bytes, "shard").check(); });
  EXPECT_NE(complaint.find("announces 2147483647 bytes"), std::string::npos) << complaint;
}

TEST(Episodes, HaveFiniteNumbersOnly) {
  Recording recording;
  RecordedSensor& sensor = recording.sensors.emplace_back();
  sensor.taxel_ids = {7};
  sensor.taxel_names = {"tip"};
  sensor.calibrated_unit = "N";
  sensor.shear = true;
  SensorRecord& record = recording.rows.emplace_back().sensors.emplace_back();
  record.readings = {1}, record.calibrated = {2}, record.shear = {dvec2(3, 4)};
  recording.mocap.emplace_back();
  EXPECT_EQ(episode_of(recording, true).rows, 1);
  const std::pair<double*, const char*> numbers[] = {{&record.readings[0], "the reading of taxel 7"},
                                                     {&record.calibrated[0], "the calibrated value of taxel 7"},
                                                     {&record.shear[0].y, "the shear of taxel 7"},
                                                     {&record.force_W.z, "the contact force"}};
  for (const auto& [number, name] : numbers) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      const double good = std::exchange(*number, bad);
      EXPECT_EQ(complaint_of([&] { episode_of(recording, true); }),
                std::string(name) + " is not finite at step 0: a modulus, velocity or size is too large");
      *number = good;
    }
  }
}

TEST(Shard, RefusesEachDescriptionThatIsCutShort) {
  ShardHead head;
  head.group = "group";
  head.outcomes = {{"a", 3, {1, 2, 3, 4}, ""}, {"b", 0, {}, "unstable"}};
  head.sensor = EpisodeSensor{"key", "{}", "finger", {1, 2}, {"tip", ""}, "Pa", "N"};
  head.columns = {{kContactForce, 3, true}, {kTimestamp, 1, false}};
  const std::string text = shard_head_to_json(head);
  EXPECT_EQ(parse_shard_head(text, "s"), head);
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_THROW(parse_shard_head(text.substr(0, size), "s"), Error) << size;
}

// A width of all bits would allow an array of any width, and rows would be copied from outside of its values.
TEST(Shard, RefusesCountsThatNoArrayHas) {
  ShardHead head;
  head.group = "group";
  head.outcomes = {{"a", 3, {}, ""}};
  head.columns = {{kTactile, 7, true}};
  const std::string text = shard_head_to_json(head);
  for (const char* count : {R"("width":7)", R"("rows":3)"}) {
    const std::string key = std::string(count).substr(0, std::string(count).size() - 1);
    std::string changed = text;
    changed.replace(changed.find(count), std::string(count).size(), key + "18446744073709551615");
    const std::string complaint = complaint_of([&] { parse_shard_head(changed, "s"); });
    EXPECT_NE(complaint.find("must be at most 2147483647"), std::string::npos) << complaint;
  }
}

constexpr const char* kBatch = R"({"format": "taxel-batch", "version": 1, "program": "taxel 9", "bits": 64})";

TEST(BatchIndex, RefusesOtherFilesAndNewerVersionsWithTheRemedy) {
  const std::vector<std::pair<std::string, std::string>> texts{
      {"{", "line 1, column 2: is not JSON"},
      {"[]", "must be an object"},
      {"{}", "/format: must be taxel-batch"},
      {R"({"format": "taxel-batch"})", "/version: is missing"},
      {R"({"format": "taxel-batch", "version": 2})",
       "/version: is 2, this program reads version 1: update this program"},
      {R"({"format": "taxel-batch", "version": 1, "program": "p", "bits": 16})", "/bits: must be 32 or 64, is 16"}};
  for (const auto& [text, message] : texts) {
    const std::string complaint = complaint_of([&] { parse_batch_index({text, "", "", ""}, "b"); });
    EXPECT_TRUE(complaint.starts_with("b/batch.json: " + message)) << complaint;
  }
}

TEST(BatchIndex, NamesMissingFilesWithTheRemedy) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch);
  const std::filesystem::path root = batch.plan().folder;
  const auto complaint = [&] { return complaint_of([&] { read_batch_index(root); }); };
  for (const char* name : {"layouts.jsonl", "batch.json"}) {
    std::filesystem::remove(root / name);
    EXPECT_EQ(complaint(), (root / name).string() +
                               ": no such file: the folder is no batch of `taxel batch`, or was copied in part");
  }
  make_folder(root / ".batch");
  EXPECT_EQ(complaint(), (root / "batch.json").string() +
                             ": no such file: the batch is not finished; run the same `taxel batch` command again");
  EXPECT_EQ(complaint_of([&] { read_batch_index(folder / "gone"); }), (folder / "gone").string() + ": no such folder");
}

TEST(BatchIndex, NamesTheDamagedLine) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch);
  const std::filesystem::path root = batch.plan().folder;
  const BatchTexts good{kBatch, read_file(root / "episodes.jsonl"), read_file(root / "layouts.jsonl"),
                        read_file(root / "failed.jsonl")};
  EXPECT_EQ(parse_batch_index(good, "b").episodes.size(), 5U);
  const auto complaint = [&](std::string BatchTexts::*text, const std::string& from, const std::string& to) {
    BatchTexts texts = good;
    std::string& changed = texts.*text;
    changed.replace(changed.find(from), from.size(), to);
    return complaint_of([&] { parse_batch_index(texts, "b"); });
  };
  EXPECT_EQ(complaint(&BatchTexts::episodes, "\"rows\":6", "\"rows\":0"),
            "b/episodes.jsonl: line 2: /rows: must be positive");
  EXPECT_EQ(complaint(&BatchTexts::episodes, "\"episode\":1", "\"episode\":7"),
            "b/episodes.jsonl: line 2: /episode: must be 1, the number of the line from 0");
  EXPECT_EQ(complaint(&BatchTexts::episodes, "\"layout\":1", "\"layout\":2"),
            "b/episodes.jsonl: line 4: /layout: is in no line of layouts.jsonl");
  EXPECT_EQ(complaint(&BatchTexts::episodes, "\"shards/", "\"shards/../../"),
            "b/episodes.jsonl: line 1: /shard: must be shards/NAME");
  EXPECT_EQ(complaint(&BatchTexts::layouts, "[0,1,2]", "[0,1]"),
            "b/layouts.jsonl: line 1: /taxel_names: must have as many texts as taxel_ids");
  EXPECT_TRUE(complaint(&BatchTexts::failed, "{", "[").starts_with("b/failed.jsonl: line 1: "));
  for (const char* line : {"{", "3", R"({"line": 1})", R"({"line": 1, "error": 2})",
                           R"({"line": 1, "error": "e", "number": 0, "job": "", "changes": []})"}) {
    const BatchTexts texts{kBatch, "", "", "\n" + std::string(line) + "\n"};
    EXPECT_TRUE(complaint_of([&] { parse_batch_index(texts, "b"); }).starts_with("b/failed.jsonl: line 2: ")) << line;
  }
}

TEST(BatchIndex, TakesNumbersFromTexts) {
  EXPECT_EQ(number_of_json("0.25"), 0.25);
  EXPECT_EQ(number_of_json("\"0.25\""), std::nullopt);
  EXPECT_EQ(number_of_json("1 2"), std::nullopt);
}

/// Writes files into the staging folder of a batch and publishes them.
std::vector<PublishedFile> published(const BatchFolder& batch, const std::map<std::string, std::string>& files,
                                     const std::vector<PublishedFile>& before) {
  const std::filesystem::path staging = batch.empty_staging();
  for (const auto& [name, bytes] : files) {
    make_folder((staging / name).parent_path());
    write_file_atomically(staging / name, bytes);
  }
  std::vector<PublishedFile> list = batch.staged_files();
  batch.publish(list, before);
  return list;
}

TEST(BatchFolder, PublishesItsHeadLast) {
  const TempFolder folder;
  const BatchFolder batch(folder / "out");
  write_file_atomically(batch.journal(), "");
  const auto files =
      published(batch, {{"batch.json", "{}"}, {"meshes/a", "1"}, {"summary.csv", ""}, {"layouts.jsonl", ""}}, {});
  std::vector<std::string> names;
  for (const PublishedFile& file : files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"layouts.jsonl", "meshes/a", "summary.csv", "batch.json"}));
  // A process that was killed while it published begins again.
  published(batch, {{"meshes/a", "2"}}, files);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/batch.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/summary.csv")) << "it is no part of the new batch";
  EXPECT_EQ(read_file(folder / "out/meshes/a"), "2");
  EXPECT_EQ(complaint_of([&] { BatchFolder{folder / "out"}; }).substr((folder / "out").string().size()),
            ": another batch writes into this folder: wait for its end, or give another folder");
}

TEST(BatchFolder, ReplacesOnlyFilesThatABatchHasWritten) {
  const TempFolder folder;
  const BatchFolder batch(folder / "out");
  const auto files = published(batch, {{"meshes/a", "1"}, {"batch.json", "{}"}}, {});
  write_file_atomically(folder / "out/meshes/mine", "mine");
  write_file_atomically(folder / "out/meshes/a", "edited");
  const std::string target = (folder / "out/meshes/a").string();
  EXPECT_EQ(complaint_of([&] {
              published(batch, {{"meshes/a", "2"}}, files);
            }),
            target + ": exists, and no batch has written it: remove it, or give another folder");
  EXPECT_TRUE(std::filesystem::exists(folder / "out/batch.json")) << "nothing was moved";
  EXPECT_EQ(
      complaint_of([&] { static_cast<void>(batch.first_missing(files)); }),
      target + ": is not as the batch has written it: remove it to have it written again, or give another folder");
  std::filesystem::remove(target);
  EXPECT_EQ(batch.first_missing(files), "meshes/a");
  published(batch, {{"meshes/a", "2"}}, files);
  EXPECT_EQ(read_file(folder / "out/meshes/mine"), "mine");
}

TEST(BatchFolder, FollowsNoLinkInThePlaceOfItsOwnFiles) {
  for (const char* own : {".batch", ".batch/staging", ".batch/lock", ".batch/journal"}) {
    const TempFolder folder;
    make_folder(folder / "elsewhere");
    make_folder((folder / "out" / own).parent_path());
    std::filesystem::create_symlink(folder / "elsewhere", folder / "out" / own);
    EXPECT_EQ(complaint_of([&] { BatchFolder{folder / "out"}; }),
              (folder / "out" / own).string() +
                  ": is a link, and a batch writes its own files into its folder only: remove the link");
    EXPECT_TRUE(std::filesystem::is_empty(folder / "elsewhere")) << own;
  }
}

}  // namespace
}  // namespace taxel::test
