// Signals to a command that computes and writes: it writes complete files or none, and its status names the signal.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Returns the files below `folder` with a temporary name.
std::vector<std::string> temporary_paths(const fs::path& folder) {
  std::vector<std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".part") found.push_back(entry.path().string());
  return found;
}

void write_slow_study(const fs::path& file) {
  Json depths = Json::array();
  for (int i = 0; i < 200; ++i) depths.push_back(0.0005 + 1e-6 * i);
  const Json press{{"kind", "press"}, {"hold", 0.1}, {"clearance", 0.0002}, {"tilt_deg", 20}, {"shape", "plate"}};
  write_text(file, Json{{"format", "taxel-study"},
                        {"version", 1},
                        {"scenario", press},
                        {"parameters", {{{"parameter", "depth"}, {"values", depths}}}}}
                       .dump());
}

/// Kills a run in several phases. The next run into the same folder must find the rows on disk.
void expect_rows_after_a_kill(const std::vector<std::string>& command, const std::string& file) {
  const fs::path folder = test_folder();
  if (!file.empty()) write_text(folder / "scenario.json", file);
  const auto with_out = [&](const std::string& out) {
    std::vector<std::string> all = command;
    all.insert(all.end(), {"--out", out});
    return all;
  };
  ASSERT_EQ(taxel(with_out("whole"), folder).status, 0);
  EXPECT_FALSE(fs::exists(folder / "whole/unfinished.rows"));
  const std::string whole = file_text(folder / "whole/readings.csv");
  for (const std::uintmax_t bytes : {1000, 20000}) {
    const std::string out = "out" + std::to_string(bytes);
    const fs::path rows = folder / out / "unfinished.rows";
    const Running run(with_out(out), folder);
    std::error_code missing;
    ASSERT_TRUE(wait_until([&] { return fs::exists(rows) && fs::file_size(rows, missing) >= bytes; }));
    run.send(SIGKILL);
    EXPECT_EQ(run.wait().status, 128 + SIGKILL);
    const Outcome next = taxel(with_out(out), folder);
    EXPECT_EQ(next.status, 0);
    const fs::path found = folder / (out + "-recovered");
    EXPECT_NE(next.err.find("an earlier run was killed"), std::string::npos) << next.err;
    EXPECT_NE(next.err.find(found.string()), std::string::npos) << next.err;
    const std::string recovered = file_text(found / "readings.csv");
    EXPECT_GT(std::count(recovered.begin(), recovered.end(), '\n'), 2);
    EXPECT_EQ(recovered, whole.substr(0, recovered.size()));
    EXPECT_EQ(recovered.back(), '\n');
    EXPECT_EQ(file_text(folder / out / "readings.csv"), whole);
    EXPECT_TRUE(temporary_paths(folder).empty());
    EXPECT_FALSE(fs::exists(rows));
  }
}

TEST(Kill, LosesNoRowOfARun) {
  expect_rows_after_a_kill({"run", TAXEL_SOURCE_DIR "/assets/scenes/press.xml", "--seconds", "0.2"}, "");
}

TEST(Kill, LosesNoRowOfAScenario) {
  expect_rows_after_a_kill({"play", "scenario.json", "--density", "1e5"},
                           R"({"format": "taxel-scenario", "version": 1, "scenario":
                               {"kind": "sweep", "shape": "box", "before": 0.002, "speed": 0.02}})");
}

class Signals : public testing::TestWithParam<int> {};

TEST_P(Signals, KeepTheEndedRunsOfAStudy) {
  const fs::path folder = test_folder();
  write_slow_study(folder / "study.json");
  const Running study({"study", "study.json", "--density", "1e5", "--out", "out"}, folder);
  const auto has_run = [&](int number) { return fs::exists(folder / fmt::format("out/run_{:03}.npz", number)); };
  const auto two_have_ended = [&] { return has_run(0) + has_run(1) + has_run(2) + has_run(3) >= 2; };
  ASSERT_TRUE(wait_until(two_have_ended));  // in any order: runs take place side by side
  study.send(GetParam());
  const Outcome outcome = study.wait();
  EXPECT_EQ(outcome.status, 128 + GetParam()) << outcome.err;
  EXPECT_TRUE(temporary_paths(folder).empty());
  const std::string runs = file_text(folder / "out/runs.csv");
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out")) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("run_") || !name.ends_with(".csv")) continue;
    ++files;
    EXPECT_NE(runs.find(name), std::string::npos) << name;
    EXPECT_TRUE(fs::exists(folder / "out" / (entry.path().stem().string() + ".npz")));
  }
  EXPECT_GE(files, 2U);
  EXPECT_LT(files, 200U);
  EXPECT_EQ(read_csv(folder / "out/summary.csv").at("peak").size(), 12 * files);
}

TEST_P(Signals, KeepTheRecordedRowsOfASweep) {
  const fs::path folder = test_folder();
  const Running sweep({"sweep", "--density", "1e5", "--timestep", "1e-5", "--out", "out"}, folder);
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "out"); }));
  std::this_thread::sleep_for(std::chrono::seconds(2));
  sweep.send(GetParam());
  const Outcome outcome = sweep.wait();
  EXPECT_EQ(outcome.status, 128 + GetParam()) << outcome.err;
  EXPECT_TRUE(temporary_paths(folder).empty());
  if (!fs::exists(folder / "out")) return;  // the signal came before the first step
  EXPECT_NE(outcome.err.find("ended by SIG"), std::string::npos) << outcome.err;
  const std::size_t rows = read_csv(folder / "out/readings.csv").at("time").size();
  EXPECT_GE(rows, 1U);
  EXPECT_LT(rows, 501U);
  EXPECT_EQ(parse_npz(file_text(folder / "out/readings.npz")).at("time").shape.at(0), rows);
}

TEST_P(Signals, LeaveNothingBeforeTheFirstStep) {
  const fs::path folder = test_folder();
  const Running sweep({"sweep", "--density", "4e8", "--out", "deep/out"}, folder);
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "deep/out"); }));
  sweep.send(GetParam());
  EXPECT_EQ(sweep.wait().status, 128 + GetParam());
  EXPECT_FALSE(fs::exists(folder / "deep"));
}

INSTANTIATE_TEST_SUITE_P(All, Signals, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(SignalsToCommands, LeaveFilesThatTheNextRunClears) {
  const fs::path folder = test_folder();
  const Running killed({"sweep", "--density", "1e5", "--timestep", "1e-5", "--out", "out"}, folder);
  ASSERT_TRUE(wait_until([&] { return !temporary_paths(folder).empty(); }));
  killed.send(SIGKILL);
  EXPECT_EQ(killed.wait().status, 128 + SIGKILL);
  EXPECT_FALSE(temporary_paths(folder).empty());
  const Outcome next = taxel({"sweep", "--object", "box", "--density", "1e5", "--out", "out", "--quiet"}, folder);
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_TRUE(temporary_paths(folder).empty());
}

TEST(SignalsToCommands, StayIgnoredIfTheyWereIgnored) {
  const fs::path folder = test_folder();
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does
  const Running sweep({"sweep", "--object", "box", "--density", "1e5", "--out", "out"}, folder);
  std::signal(SIGHUP, before);
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "out"); }));
  sweep.send(SIGHUP);
  EXPECT_EQ(sweep.wait().status, 0);
}

}  // namespace
}  // namespace taxel::test
