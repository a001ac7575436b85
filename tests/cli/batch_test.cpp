// `taxel batch`: a batch that is killed loses and repeats nothing, its rows are those of `taxel play`, and bad input is
// named while the other jobs run.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "cli/taxel_program.h"
#include "core/run/batch/batch_index.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* kPress =
    R"("scenario": {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"})";

/// Returns a line of a list with short presses of a fingertip with few samples.
std::string press_line(const std::string& set, int repeat = 1) {
  return std::string("{") + kPress + R"(, "set": {"/layout/sampling/density": 1e5)" + (set.empty() ? "" : ", ") + set +
         "}, \"repeat\": " + std::to_string(repeat) + "}\n";
}

/// Returns 40 jobs of four layouts.
std::string forty_jobs() {
  return press_line(
      R"("/layout/sampling/seed": {"values": [1, 2, 3, 4]}, "/scenario/depth": {"uniform": [0.0003, 0.0009]})", 10);
}

Outcome batch(const fs::path& folder, std::vector<std::string> more) {
  more.insert(more.begin(), {"batch", "jobs.jsonl", "--quiet"});
  return taxel(more, folder);
}

/// Returns the bytes of all files of a batch by their paths, without the folder of its journal.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && !name.starts_with(".batch")) files[name] = file_text(entry.path());
  }
  return files;
}

std::size_t journal_lines(const fs::path& folder) {
  const fs::path journal = folder / ".batch/journal";
  if (!fs::exists(journal)) return 0;
  const std::string text = file_text(journal);
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

/// Starts a batch and sends a signal when its journal has `groups` groups.
Outcome interrupt_after(std::size_t groups, int signal, const std::vector<std::string>& arguments,
                        const fs::path& folder, const fs::path& out) {
  const Running running(arguments, folder);
  EXPECT_TRUE(wait_until([&] { return running.has_ended() || journal_lines(out) > groups; }));
  running.send(signal);
  return running.wait();
}

TEST(Batch, LosesAndRepeatsNothingIfItIsKilled) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", forty_jobs());
  const Outcome whole = batch(folder, {"--out", "whole", "--workers", "1", "--group", "2"});
  ASSERT_EQ(whole.status, 0) << whole.err;
  const std::vector<std::string> arguments{"batch", "jobs.jsonl", "--out", "killed", "--workers", "2", "--group", "2"};
  for (const std::size_t groups : {6U, 12U}) {  // of 20
    ASSERT_EQ(interrupt_after(groups, SIGKILL, arguments, folder, folder / "killed").status, 128 + SIGKILL);
    ASSERT_FALSE(fs::exists(folder / "killed/batch.json"));
  }
  const std::size_t before = journal_lines(folder / "killed") - 1;
  const Json report = Json::parse(batch(folder, {"--out", "killed", "--workers", "2", "--group", "2", "--json"}).out);
  EXPECT_GE(report["resumed"].get<std::size_t>(), 2 * before);
  EXPECT_EQ(report["episodes"], 40);
  EXPECT_EQ(files_of(folder / "killed"), files_of(folder / "whole"));
  std::set<std::string> jobs;
  for (const EpisodeEntry& episode : read_batch_index(folder / "killed").episodes) jobs.insert(episode.job);
  EXPECT_EQ(jobs.size(), 40U);
  EXPECT_EQ(journal_lines(folder / "killed"), 23U);  // the head, 20 groups once, the files and the end
  const Json again = Json::parse(batch(folder, {"--out", "killed", "--group", "2", "--json"}).out);
  EXPECT_EQ(again["was_complete"], true);
}

TEST(Batch, HasTheRowsOfPlay) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", press_line(R"("/scenario/depth": {"values": [0.0004, 0.0008]})"));
  const Outcome outcome = batch(folder, {"--out", "out", "--float64", "--poses", "--npz"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  write_text(folder / "one.json",
             R"({"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate", "depth": 0.0008})");
  ASSERT_EQ(taxel({"play", "one.json", "--density", "1e5", "--out", "played"}, folder).status, 0);
  const auto played = parse_npz(file_text(folder / "played/readings.npz"));
  const BatchIndex index = read_batch_index(folder / "out");
  ASSERT_EQ(index.episodes.size(), 2U);
  const EpisodeEntry& episode = index.episodes[1];
  const Shard shard(folder / "out" / episode.shard);
  const std::vector<std::pair<const char*, const char*>> names{
      {kTimestamp, "time"}, {kTactile, "readings"}, {kContactForce, "force"}, {kTravel, "travel"}};
  for (const auto& [column, array] : names) {
    const EpisodeColumn rows = shard.rows(column, episode.first_row, episode.rows);
    EXPECT_EQ(rows.values, played.at(array).doubles()) << column;
    EXPECT_FALSE(rows.values.empty());
  }
  const std::string run = "out/runs/" + episode.job.substr(0, 32) + ".npz";
  EXPECT_EQ(file_text(folder / run), file_text(folder / "played/readings.npz"));
  EXPECT_EQ(index.layouts[0].taxel_ids.size(), 12U);
}

TEST(Batch, RoundsToFloat32AtTheEnd) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", press_line(""));
  ASSERT_EQ(batch(folder, {"--out", "short"}).status, 0);
  ASSERT_EQ(batch(folder, {"--out", "long", "--float64"}).status, 0);
  const EpisodeEntry entry = read_batch_index(folder / "short").episodes.at(0);
  const Shard rounded(folder / "short" / entry.shard), exact(folder / "long" / entry.shard);
  ASSERT_EQ(rounded.head().columns, exact.head().columns);
  for (const ShardColumn& column : exact.head().columns) {
    const std::vector<double> shorter = rounded.rows(column.name, 0, entry.rows).values,
                              longer = exact.rows(column.name, 0, entry.rows).values;
    for (std::size_t k = 0; k < longer.size(); ++k)
      ASSERT_EQ(shorter[k], static_cast<double>(static_cast<float>(longer[k]))) << column.name;
  }
}

TEST(Batch, NamesFailedJobsAndRunsTheOthers) {
  const fs::path folder = test_folder();
  write_text(folder / "triangle.obj", "v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\nf 1 2 3\n");
  Json layout = Json::parse(file_text(fingertip_layout()));
  layout["mesh"] = {{"file", "triangle.obj"}};
  write_text(folder / "open.taxels.json", layout.dump());
  write_text(folder / "jobs.jsonl", press_line(R"("/scenario/finger_mass": {"values": [0.02, 1e-15]})") +
                                        "{\"scenario\": \n" + press_line(R"("/scenario/dept": 1)") +
                                        "{\"layout\": \"open.taxels.json\", " + kPress + "}\n");
  const Outcome outcome = taxel({"batch", "jobs.jsonl", "--out", "out", "--json"}, folder);
  EXPECT_EQ(outcome.status, 1);
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["episodes"], 1);
  ASSERT_EQ(report["broken_lines"].size(), 2U);
  EXPECT_EQ(report["broken_lines"][0]["line"], 2);
  EXPECT_EQ(report["broken_lines"][1]["error"], "/scenario/dept: unknown key; did you mean \"depth\"?");
  ASSERT_EQ(report["failed"].size(), 2U);
  EXPECT_EQ(report["failed"][0]["line"], 1);
  EXPECT_NE(report["failed"][0]["error"].get<std::string>().find("inertia"), std::string::npos);
  EXPECT_EQ(report["failed"][1]["line"], 4);
  EXPECT_NE(outcome.err.find("jobs.jsonl: line 2: line 1"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("line 4, job 0: "), std::string::npos) << outcome.err;
  const std::string failed = file_text(folder / "out/failed.jsonl");
  EXPECT_EQ(std::ranges::count(failed, '\n'), 4);
}

TEST(Batch, ContinuesAfterAFullDisk) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", forty_jobs());
  const std::string command = "exec " TAXEL_PROGRAM " batch jobs.jsonl --workers 2 --group 10 --out ";
  ASSERT_EQ(run_program("/bin/sh", {"-c", command + "whole"}, folder).status, 0);
  // A limit of 4 kB for each file replaces a full disk: no shard of ten jobs fits.
  const Outcome full = run_program("/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 8; " + command + "full"}, folder);
  EXPECT_EQ(full.status, 2);
  EXPECT_NE(full.err.find("writing failed: File too large"), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("the same command continues"), std::string::npos) << full.err;
  EXPECT_FALSE(fs::exists(folder / "full/batch.json"));
  ASSERT_EQ(run_program("/bin/sh", {"-c", command + "full"}, folder).status, 0);
  EXPECT_EQ(files_of(folder / "full"), files_of(folder / "whole"));
}

/// A batch that was ended by SIGTERM after some of its groups.
class InterruptedBatch : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "jobs.jsonl", forty_jobs());
    ended_ = interrupt_after(8, SIGTERM, arguments_, folder_, out_);
    ASSERT_EQ(ended_.status, 128 + SIGTERM);
  }
  /// Returns the files of a batch that was not interrupted.
  [[nodiscard]] std::map<std::string, std::string> whole() const {
    EXPECT_EQ(batch(folder_, {"--out", "whole", "--group", "2"}).status, 0);
    return files_of(folder_ / "whole");
  }
  [[nodiscard]] Outcome resume() const { return taxel(arguments_, folder_); }

  Outcome ended_;
  fs::path folder_ = test_folder();
  fs::path out_ = folder_ / "out";
  fs::path journal_ = out_ / ".batch/journal";
  std::vector<std::string> arguments_{"batch", "jobs.jsonl", "--out", "out", "--workers", "2", "--group", "2"};
};

TEST_F(InterruptedBatch, SaysHowToContinue) {
  EXPECT_NE(ended_.err.find("of 40 jobs: the same command continues"), std::string::npos);
  EXPECT_FALSE(fs::exists(out_ / "batch.json"));
}

TEST_F(InterruptedBatch, ContinuesWithAJournalThatIsCutShort) {
  const std::string text = file_text(journal_);
  for (const std::size_t size : {text.size() - 1, text.size() / 2, std::size_t{5}, std::size_t{0}}) {
    fs::remove_all(folder_ / "cut");
    fs::copy(out_, folder_ / "cut", fs::copy_options::recursive);
    write_text(folder_ / "cut/.batch/journal", text.substr(0, size));
    const Outcome outcome = batch(folder_, {"--out", "cut", "--group", "2", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GE(Json::parse(outcome.out)["resumed"], 16);  // the shards are there
    EXPECT_EQ(files_of(folder_ / "cut"), whole());
  }
}

TEST_F(InterruptedBatch, RunsDamagedGroupsAgain) {
  const fs::path shard = fs::directory_iterator(out_ / "shards")->path();
  write_text(shard, file_text(shard).substr(0, 100));
  const Outcome outcome = resume();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("the results are missing or damaged, so 2 jobs run again"), std::string::npos);
  EXPECT_EQ(files_of(out_), whole());
}

TEST_F(InterruptedBatch, RunsGroupsAgainWhoseRunFilesAreMissing) {
  arguments_.push_back("--npz");
  const Outcome outcome = resume();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("so 2 jobs run again"), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(out_ / "runs"), fs::directory_iterator()), 40);
}

TEST_F(InterruptedBatch, RefusesAnotherBatchInItsFolder) {
  const std::string prefix = "taxel: out/.batch/journal: belongs to another batch: ";
  const std::string remedy = "; give another folder, or remove this one\n";
  EXPECT_EQ(batch(folder_, {"--out", "out", "--group", "2", "--float64"}).err,
            prefix + "its numbers have 32 bits" + remedy);
  EXPECT_EQ(batch(folder_, {"--out", "out", "--group", "4"}).err, prefix + "its groups have up to 2 jobs" + remedy);
  write_text(folder_ / "jobs.jsonl", press_line(""));
  EXPECT_EQ(batch(folder_, {"--out", "out", "--group", "2"}).err, prefix + "its list has other jobs" + remedy);
}

TEST_F(InterruptedBatch, RefusesAFolderThatAnotherProcessUses) {
  const int lock = ::open((out_ / ".batch/lock").c_str(), O_RDWR);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  expect_refusal(batch(folder_, {"--out", "out", "--group", "2"}),
                 "taxel: out: another batch writes into this folder: wait for its end, or give another folder");
  ::close(lock);
}

/// Returns a list of presses of the shipped scene at random places, with boxes of two kinds.
std::string scene_jobs(int repeat) {
  return R"({"scene": {"file": ")" TAXEL_SOURCE_DIR R"(/assets/scenes/press.xml", "seconds": 0.1, "controls": )"
         R"({"time": [0, 0.05], "actuator 0": [0, -0.02]}}, "set": {"/scene/moves/box/x": {"uniform": [-0.004, 0.004]}, )"
         R"("/scene/geoms/box/size": {"choice": [[0.02, 0.02, 0.02], [0.015, 0.02, 0.02]]}}, "repeat": )" +
         std::to_string(repeat) + "}\n";
}

TEST(SceneBatch, LosesAndRepeatsNothingIfItIsKilled) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", scene_jobs(24));
  const Outcome whole = batch(folder, {"--out", "whole", "--workers", "1", "--group", "2"});
  ASSERT_EQ(whole.status, 0) << whole.err;
  const std::vector<std::string> arguments{"batch", "jobs.jsonl", "--out", "killed", "--workers", "2", "--group", "2"};
  for (const std::size_t groups : {3U, 7U}) {  // of 12 or 13
    ASSERT_EQ(interrupt_after(groups, SIGKILL, arguments, folder, folder / "killed").status, 128 + SIGKILL);
    ASSERT_FALSE(fs::exists(folder / "killed/batch.json"));
  }
  const Json report = Json::parse(batch(folder, {"--out", "killed", "--workers", "2", "--group", "2", "--json"}).out);
  EXPECT_GE(report["resumed"].get<std::size_t>(), 14U);
  EXPECT_EQ(report["episodes"], 24);
  EXPECT_EQ(files_of(folder / "killed"), files_of(folder / "whole"));
}

TEST(SceneBatch, RefusesOptionsThatGoWithScenarios) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", scene_jobs(1));
  Outcome outcome = batch(folder, {"--out", "out", "--events", "--remote"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "taxel: batch: --remote: runs scenarios alone: scenes and their files do not travel to another process\n");
  outcome = batch(folder, {"--out", "out", "--fps", "50"});
  EXPECT_EQ(outcome.err, "taxel: batch: --fps: is for scenarios: give the scenes a /scene/record_interval\n");
  write_text(folder / "jobs.jsonl", R"({"scene": {"file": ")" TAXEL_SOURCE_DIR
                                    R"(/assets/scenes/press.xml", "seconds": 1, "policy": "mine"}})");
  outcome = batch(folder, {"--out", "out"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "taxel: jobs.jsonl: line 1: /scene/policy: \"mine\" is a function of Python: call taxel.batch(jobs, "
            "out, policy=...)\n");
  write_text(folder / "plain.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>");
  write_text(folder / "jobs.jsonl", R"({"scene": {"file": "plain.xml", "seconds": 1}})");
  outcome = batch(folder, {"--out", "out"});
  EXPECT_NE(outcome.err.find("declares no taxel.sensor and no taxel.contact; attach a layout by /scene/attach"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(BatchFolder, RefusesFilesOfSomethingElse) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", press_line(""));
  fs::create_directories(folder / "out/shards");
  expect_refusal(batch(folder, {"--out", "out"}),
                 "taxel: out: has \"shards\" already, which no batch has written: give another folder");
  write_text(folder / "jobs.jsonl", "\n\n");
  expect_refusal(batch(folder, {"--out", "other"}), "taxel: jobs.jsonl: has no job");
  write_text(folder / "jobs.jsonl", "\n7\n");
  expect_refusal(batch(folder, {"--out", "other", "--quiet"}),
                 "taxel: jobs.jsonl: has no job that can run: line 2: must be an object, is 7");
}

}  // namespace
}  // namespace taxel::test
