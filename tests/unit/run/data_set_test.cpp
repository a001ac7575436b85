// Data sets: written from shards, read again, and damaged ones.
#include "core/run/batch/data_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/rng.h"
#include "core/document/batch/job.h"
#include "core/run/batch/batch_folder.h"
#include "core/run/batch/data_set_meta.h"
#include "core/run/batch/write_data_set.h"
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
      : second_name_(std::move(second_name)), shards_(folder / "shards") {
    make_folder(shards_);
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
  [[nodiscard]] DataSetPlan plan() const { return {list_, groups_, shards_, format_, "taxel test"}; }
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
    write_file_atomically(shards_ / shard_name(group.id), shard_bytes(result, format_));
  }

  JobList list_;
  std::vector<JobGroup> groups_;
  std::string second_name_;  // of the taxels of the second layout
  std::filesystem::path shards_;
  BatchFormat format_{true, false, 2};
  std::map<std::string, Episode> episodes_;
};

DataSetCounts write(const MadeBatch& batch, const std::filesystem::path& folder) {
  make_folder(folder);
  return write_data_set(folder, batch.plan(), [](double) {});
}

nlohmann::json read_json(const std::filesystem::path& path) {
  return nlohmann::json::parse(read_file(path));
}

TEST(JobGroups, HaveOneLayoutAndLeaveOutBrokenJobs) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  std::vector<std::vector<std::size_t>> jobs;
  for (const JobGroup& group : batch.plan().groups) jobs.push_back(group.jobs);
  EXPECT_EQ(jobs, (std::vector<std::vector<std::size_t>>{{0, 2}, {4}, {1, 3}, {5}}));
}

TEST(DataSet, ReturnsTheEpisodesOfAllShards) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const DataSetCounts counts = write(batch, folder / "set");
  EXPECT_EQ(counts.episodes, 5);
  ASSERT_EQ(counts.failed.size(), 2U);
  EXPECT_EQ(counts.failed[0].error, "the simulation became unstable");
  EXPECT_EQ(counts.failed[1].line, 7);
  const DataSet set(folder / "set");
  std::vector<std::string> jobs;
  for (const EpisodeEntry& entry : set.episodes()) {
    jobs.push_back(entry.job);
    const Episode read = set.read_episode(static_cast<std::size_t>(entry.index));
    const Episode& made = batch.episode(entry.job);
    EXPECT_EQ(read.rows, made.rows);
    EXPECT_EQ(read.summary, made.summary);
    for (const EpisodeColumn& column : made.columns) {
      const auto found = std::ranges::find(read.columns, column.name, &EpisodeColumn::name);
      ASSERT_NE(found, read.columns.end()) << column.name;
      EXPECT_EQ(found->values, column.values);
      EXPECT_EQ(found->width, column.width);
    }
  }
  EXPECT_EQ(jobs, (std::vector<std::string>{"job0", "job2", "job4", "job1", "job5"}));
  EXPECT_EQ(set.episodes()[4].task, "slide, \"fast\"");
  EXPECT_EQ(set.layouts()[set.episodes()[4].layout].layout_key, "odd");
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

TEST(DataSet, DescribesItsColumns) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const nlohmann::json info = read_json(folder / "set/meta/info.json");
  EXPECT_EQ(info["codebase_version"], "v3.0");
  EXPECT_EQ(info["total_episodes"], 5);
  EXPECT_EQ(info["total_frames"], 4 + 6 + 8 + 5 + 9);
  EXPECT_EQ(info["total_tasks"], 2);
  EXPECT_EQ(info["fps"], 100);
  EXPECT_EQ(info["features"]["observation.tactile"]["shape"], nlohmann::json({3}));
  EXPECT_EQ(info["features"]["observation.tactile"]["dtype"], "float64");
  EXPECT_EQ(info["features"]["observation.tactile"]["unit"], "Pa");
  EXPECT_EQ(read_json(folder / "set/meta/taxel.json")["failed"], 2);
  const std::string summary = read_file(folder / "set/summary.csv");
  EXPECT_NE(summary.find("\n2,5,0,104,\"slide, \"\"fast\"\"\",0.004,8,0.07,5.5,3,2,job4\n"), std::string::npos)
      << summary;
}

TEST(DataSet, HasListsOfSeveralLengthsForSeveralLayouts) {
  const TempFolder folder;
  const MadeBatch batch(folder, 5, true);
  write(batch, folder / "set");
  const nlohmann::json features = read_json(folder / "set/meta/info.json")["features"];
  EXPECT_EQ(features["observation.tactile"]["shape"], nlohmann::json({-1}));
  EXPECT_EQ(features["observation.shear"]["shape"], nlohmann::json({-1}));  // only one layout has shear
  EXPECT_EQ(features["observation.force"]["shape"], nlohmann::json({3}));
  const DataSet set(folder / "set");
  const auto width_of = [&](std::size_t episode, const char* name) {
    const Episode read = set.read_episode(episode);
    return std::ranges::find(read.columns, name, &EpisodeColumn::name)->width;
  };
  EXPECT_EQ(width_of(0, kTactile), 3U);
  EXPECT_EQ(width_of(4, kTactile), 5U);
  EXPECT_EQ(width_of(0, kShear), 0U);
  EXPECT_EQ(width_of(4, kShear), 10U);
}

TEST(DataSet, HasStatisticsOfEachComponent) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const nlohmann::json stats = read_json(folder / "set/meta/stats.json");
  std::vector<double> forces;
  for (const char* job : {"job0", "job2", "job4", "job1", "job5"}) {
    const std::vector<double>& values = batch.episode(job).columns[3].values;
    for (std::size_t i = 1; i < values.size(); i += 3) forces.push_back(values[i]);
  }
  double mean = 0, variance = 0;
  for (const double force : forces) mean += force / static_cast<double>(forces.size());
  for (const double force : forces) variance += (force - mean) * (force - mean) / static_cast<double>(forces.size());
  const nlohmann::json& force = stats["observation.force"];
  EXPECT_NEAR(force["mean"][1].get<double>(), mean, 1e-14);
  EXPECT_NEAR(force["std"][1].get<double>(), std::sqrt(variance), 1e-14);
  EXPECT_EQ(force["min"][1], *std::ranges::min_element(forces));
  EXPECT_EQ(force["max"][1], *std::ranges::max_element(forces));
  EXPECT_EQ(force["count"], nlohmann::json({32}));
  EXPECT_EQ(stats["index"]["max"], nlohmann::json({31.0}));
}

TEST(DataSet, NamesMissingAndDamagedFiles) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const std::string rows = (folder / "set/data/chunk-000/file-000.parquet").string();
  const std::string bytes = read_file(rows);
  write_file_atomically(rows, bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(complaint_of([&] { static_cast<void>(DataSet(folder / "set").read_episode(0)); }),
            rows + ": is not a Parquet file, or a part of one");
  write_file_atomically(rows, parquet_bytes({{"a", ParquetType::int64}}, {{std::vector<std::int64_t>{1}, {}}}));
  EXPECT_EQ(complaint_of([&] { static_cast<void>(DataSet(folder / "set").read_episode(0)); }),
            rows + ": has not the rows of episode 0");
  const std::string layouts = (folder / "set/meta/layouts.parquet").string();
  std::filesystem::remove(layouts);
  EXPECT_EQ(complaint_of([&] { DataSet{folder / "set"}; }), layouts + ": no such file");
}

// A table of layouts has each layout once, and one text in each cell.
TEST(DataSet, RefusesATableOfLayoutsThatIsNone) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const std::string layouts = (folder / "set/meta/layouts.parquet").string();
  const auto complaint = [&](const std::vector<std::string>& keys, const ParquetCells& names) {
    const std::vector<std::string> texts(keys.size(), "{}");
    const std::vector<std::int32_t> lengths(keys.size(), 1);
    write_file_atomically(layouts, parquet_bytes({{"key", ParquetType::text},
                                                  {"name", ParquetType::text, !names.lengths.empty()},
                                                  {"unit", ParquetType::text},
                                                  {"calibrated_unit", ParquetType::text},
                                                  {"taxel_ids", ParquetType::int64, true},
                                                  {"taxel_names", ParquetType::text, true},
                                                  {"layout", ParquetType::text}},
                                                 {{keys, {}},
                                                  names,
                                                  {texts, {}},
                                                  {texts, {}},
                                                  {std::vector<std::int64_t>(keys.size(), 0), lengths},
                                                  {texts, lengths},
                                                  {texts, {}}}));
    return complaint_of([&] { DataSet{folder / "set"}; });
  };
  const std::vector<std::string> names{"a", "b"};
  EXPECT_EQ(complaint({"even", "odd"}, {names, {}}), "accepted");
  EXPECT_EQ(complaint({"even", "even"}, {names, {}}), layouts + ": key: is damaged: layout \"even\" is listed twice");
  EXPECT_EQ(complaint({"even", "odd"}, {names, {2, 0}}), layouts + ": name: is of another type than in a data set");
  EXPECT_EQ(complaint({"even"}, {std::vector<std::string>{"a"}, {}}),
            (folder / "set/meta/episodes/chunk-000/file-000.parquet").string() +
                ": row 3: is damaged: the episode has no place in the data set");
}

// Episodes of 4, 6, 8, 5 and 9 rows: the frames of each begin at 0, and the index counts all 32 rows.
TEST(DataSet, CountsTheRowsOfEachEpisode) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const ParquetFile file(folder / "set/data/chunk-000/file-000.parquet");
  std::vector<std::int64_t> frames, episodes, indices;
  for (const std::int64_t rows : {4, 6, 8, 5, 9}) {
    const std::int64_t episode = episodes.empty() ? 0 : episodes.back() + 1;
    for (std::int64_t row = 0; row < rows; ++row) {
      frames.push_back(row);
      episodes.push_back(episode);
      indices.push_back(static_cast<std::int64_t>(indices.size()));
    }
  }
  EXPECT_EQ(file.all_cells("frame_index").values, ParquetValues(frames));
  EXPECT_EQ(file.all_cells("episode_index").values, ParquetValues(episodes));
  EXPECT_EQ(file.all_cells("index").values, ParquetValues(indices));
}

TEST(DataSet, NamesTaxelsOnlyIfAllLayoutsHaveTheSame) {
  for (const std::string name : {"tip", "thumb"}) {
    const TempFolder folder;
    const MadeBatch batch(folder, 3, false, name);
    write(batch, folder / "set");
    const nlohmann::json names = read_json(folder / "set/meta/info.json")["features"]["observation.tactile"]["names"];
    EXPECT_EQ(names.is_null(), name != "tip") << names;
  }
}

TEST(DataSet, ListsBrokenLinesWithTheFailedJobs) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const std::string failed = read_file(folder / "set/meta/failed.jsonl");
  EXPECT_EQ(std::count(failed.begin(), failed.end(), '\n'), 3) << failed;
  const nlohmann::json first = nlohmann::json::parse(failed.substr(0, failed.find('\n')));
  EXPECT_EQ(first["line"], 9);
  EXPECT_EQ(first["error"], "is not JSON");
}

TEST(DataSet, IsNotWrittenFromShardsOfOtherJobs) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  const DataSetPlan plan = batch.plan();
  const auto path = [&](int i) { return plan.shards / shard_name(plan.groups[static_cast<std::size_t>(i)].id); };
  write_file_atomically(path(0), read_file(path(2)));
  const std::string refusal = path(0).string() + ": has other jobs than its name says";
  EXPECT_EQ(complaint_of([&] { write(batch, folder / "set"); }), refusal);
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
    EXPECT_EQ(complaint_of([&] { write(batch, folder / "other"); }), refusal) << c.group;
  }
}

TEST(DataSet, IsNotWrittenFromOtherJobsUnderTheNameOfAGroup) {
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

TEST(DataSet, NamesTaxelsOnlyIfAllLayoutsHaveTheirNames) {
  for (const char* second : {"tip", "pad"}) {
    const TempFolder folder;
    write(MadeBatch(folder, 3, false, second), folder / "set");
    const nlohmann::json tactile = read_json(folder / "set/meta/info.json")["features"]["observation.tactile"];
    const bool has_names = tactile.contains("names") && tactile["names"] == nlohmann::json({"tip", "tip", "tip"});
    EXPECT_EQ(has_names, second == std::string("tip")) << tactile;
  }
}

TEST(DataSet, IsNotWrittenNorReadWithADamagedPage) {
  const TempFolder folder;
  const MadeBatch batch(folder);
  write(batch, folder / "set");
  const auto flip = [](const std::filesystem::path& path) {
    std::string bytes = read_file(path);
    bytes[bytes.find("\x28\xB5\x2F\xFD") + 12] ^= 1;  // in the first page that Zstandard has compressed
    write_file_atomically(path, bytes);
  };
  const std::filesystem::path rows = folder / "set/data/chunk-000/file-000.parquet",
                              shard = batch.plan().shards / shard_name(batch.plan().groups[0].id);
  flip(rows);
  EXPECT_EQ(complaint_of([&] { static_cast<void>(DataSet(folder / "set").read_episode(0)); }).find(rows.string()), 0U);
  flip(shard);
  EXPECT_EQ(complaint_of([&] { write(batch, folder / "again"); }).find(shard.string()), 0U);
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
  head.widths = {{kContactForce, 3}};
  const std::string text = shard_head_to_json(head);
  EXPECT_EQ(parse_shard_head(text, "s"), head);
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_THROW(parse_shard_head(text.substr(0, size), "s"), Error) << size;
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

TEST(BatchFolder, PublishesMetaLast) {
  const TempFolder folder;
  const BatchFolder batch(folder / "out");
  write_file_atomically(batch.journal(), "");
  const auto files =
      published(batch, {{"meta/info.json", "{}"}, {"meta/a", "1"}, {"summary.csv", ""}, {"data/x", ""}}, {});
  std::vector<std::string> names;
  for (const PublishedFile& file : files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"data/x", "summary.csv", "meta/a", "meta/info.json"}));
  // A process that was killed while it published begins again.
  published(batch, {{"meta/a", "2"}}, files);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/meta/info.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/summary.csv")) << "it is no part of the new set";
  EXPECT_EQ(read_file(folder / "out/meta/a"), "2");
  EXPECT_EQ(complaint_of([&] { BatchFolder{folder / "out"}; }).substr((folder / "out").string().size()),
            ": another batch writes into this folder: wait for its end, or give another folder");
}

TEST(BatchFolder, ReplacesOnlyFilesThatABatchHasWritten) {
  const TempFolder folder;
  const BatchFolder batch(folder / "out");
  const auto files = published(batch, {{"data/a", "1"}, {"meta/info.json", "{}"}}, {});
  write_file_atomically(folder / "out/data/mine", "mine");
  write_file_atomically(folder / "out/data/a", "edited");
  const std::string target = (folder / "out/data/a").string();
  EXPECT_EQ(complaint_of([&] {
              published(batch, {{"data/a", "2"}}, files);
            }),
            target + ": exists, and no batch has written it: remove it, or give another folder");
  EXPECT_TRUE(std::filesystem::exists(folder / "out/meta/info.json")) << "nothing was moved";
  EXPECT_EQ(
      complaint_of([&] { static_cast<void>(batch.first_missing(files)); }),
      target + ": is not as the batch has written it: remove it to have it written again, or give another folder");
  std::filesystem::remove(target);
  EXPECT_EQ(batch.first_missing(files), "data/a");
  published(batch, {{"data/a", "2"}}, files);
  EXPECT_EQ(read_file(folder / "out/data/mine"), "mine");
}

TEST(BatchFolder, FollowsNoLinkInThePlaceOfItsOwnFiles) {
  for (const char* own : {".batch", ".batch/shards", ".batch/data_set", ".batch/lock", ".batch/journal"}) {
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
