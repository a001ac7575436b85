// `taxel study`: every run equals a single run with its values, for any number of simultaneous runs.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Returns the scenario of a short press onto a plate.
Json press() {
  return {{"kind", "press"}, {"hold", 0}, {"clearance", 0.0002}, {"tilt_deg", 20}, {"shape", "plate"}};
}
void write_study(const fs::path& file, const Json& parameters) {
  write_text(file,
             Json{{"format", "taxel-study"}, {"version", 1}, {"scenario", press()}, {"parameters", parameters}}.dump());
}

TEST(Study, EqualsSingleRunsOnAnyNumberOfThreads) {
  const fs::path folder = test_folder();
  write_study(folder / "depths.json", {{{"parameter", "depth"}, {"from", 0.0005}, {"to", 0.001}, {"count", 2}},
                                       {{"parameter", "seed"}, {"values", {3, 4}}}});
  for (const char* threads : {"1", "2"}) {
    const Outcome outcome =
        taxel({"study", "depths.json", "--density", "1e5", "--threads", threads, "--out", threads, "--quiet"}, folder);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  Json alone = press();
  alone["depth"] = 0.001;
  write_text(folder / "alone.json", alone.dump());
  ASSERT_EQ(taxel({"play", "alone.json", "--density", "1e5", "--seed", "3", "--out", "alone"}, folder).status, 0);
  EXPECT_EQ(file_text(folder / "1/run_002.csv"), file_text(folder / "alone/readings.csv"));
  for (const char* file : {"summary.csv", "runs.csv", "study.json", "run_000.csv", "run_001.npz", "run_003.npz"})
    EXPECT_EQ(file_text(folder / "1" / file), file_text(folder / "2" / file)) << file;
  EXPECT_EQ(file_text(folder / "1/runs.csv"),
            "file,depth,seed\nrun_000.csv,0.0005,3\nrun_001.csv,0.0005,4\nrun_002.csv,0.001,3\nrun_003.csv,0.001,4\n");
  const Table summary = read_csv(folder / "1/summary.csv");
  ASSERT_EQ(summary.at("peak").size(), 48U);  // 4 runs of 12 taxels
  const Table run = read_csv(folder / "1/run_002.csv");
  for (std::size_t k = 0; k < 12; ++k) {
    const std::vector<double>& values = run.at("taxel_" + std::to_string(k));
    double sum = 0;
    for (const double value : values) sum += value;
    EXPECT_EQ(summary.at("peak")[24 + k], *std::max_element(values.begin(), values.end()));
    EXPECT_NEAR(summary.at("mean")[24 + k], sum / static_cast<double>(values.size()), 1e-9 * (1 + sum));
    EXPECT_EQ(summary.at("depth")[24 + k], 0.001);
  }
  EXPECT_EQ(taxel({"check", "1/study.json"}, folder).status, 0);
}

TEST(Study, ReportsAFailedRunAndContinues) {
  const fs::path folder = test_folder();
  write_study(folder / "masses.json", {{{"parameter", "finger_mass"}, {"values", {0.02, 1e-12}}}});
  const Outcome outcome = taxel({"study", "masses.json", "--density", "1e5", "--out", "out", "--json"}, folder);
  ASSERT_EQ(outcome.status, 1) << outcome.err;
  const Json told = Json::parse(outcome.out);
  EXPECT_FALSE(told["runs"][0].contains("error"));
  EXPECT_NE(told["runs"][1]["error"].get<std::string>().find("inertia"), std::string::npos);  // too light for MuJoCo
  EXPECT_NE(outcome.err.find("run_001"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "out/run_000.npz"));
  EXPECT_FALSE(fs::exists(folder / "out/run_001.npz"));
}

}  // namespace
}  // namespace taxel::test
