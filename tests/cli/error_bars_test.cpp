// --error-bars of taxel read, sweep and run: bars of samples and of exact readings, their columns, and why a sensor has
// none.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;
using Numbers = std::vector<double>;

Json bars_of(const fs::path& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"read", "fingertip.taxels.json", "case.json", "--error-bars"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return taxel_json(arguments, folder)["error_bars"];
}

// The reading with 25 times the samples is within the bar of each taxel.
TEST(ErrorBarsOfRead, ContainTheReadingOfMoreSamples) {
  const fs::path folder = finger_on_box();
  const Json bars = bars_of(folder);
  EXPECT_EQ(bars["compared_with"], "exact");
  const Numbers readings = bars["readings"], better = bars["better"], width = bars["bars"];
  const Numbers dense = taxel_json({"read", "fingertip.taxels.json", "case.json", "--density", "2.5e7"},
                                   folder)["readings"]["weighted_mean"];
  ASSERT_EQ(width.size(), 12U);
  const double peak = *std::max_element(dense.begin(), dense.end());
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_GE(width[k], std::abs(readings[k] - better[k])) << k;
    EXPECT_NEAR(dense[k], readings[k], width[k] + 2e-3 * peak) << k;
    EXPECT_NEAR(dense[k], better[k], 0.02 * peak) << k;
  }
  EXPECT_GT(*std::max_element(width.begin(), width.end()), 1e-3 * peak);
}

TEST(ErrorBarsOfRead, CompareIntegralsWithFinerBodies) {
  const fs::path folder = finger_on_box();
  const Json sampled = bars_of(folder), force = bars_of(folder, {"--aggregate", "force"});
  EXPECT_EQ(force["compared_with"], "finer_bodies");
  const Numbers readings = force["readings"], finer = force["better"], width = force["bars"];
  for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(width[k], 4.0 / 3 * std::abs(readings[k] - finer[k]), 1e-12);
  const double peak = *std::max_element(readings.begin(), readings.end());
  const double largest = *std::max_element(width.begin(), width.end());
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.01 * peak);
  const Outcome text = taxel({"read", "fingertip.taxels.json", "case.json", "--error-bars"}, folder);
  EXPECT_NE(text.out.find("error bars of weighted_mean [Pa], compared with the exact integral"), std::string::npos);
}

TEST(ErrorBarsOfRead, AreRefusedForRaysWithoutIntegral) {
  const fs::path folder = finger_on_box(R"([{"op": "add", "path": "/readout/ray", "value": "taxel_normal"}])");
  const Outcome refused = taxel({"read", "fingertip.taxels.json", "case.json", "--error-bars"}, folder);
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("must be \"surface_normal\""), std::string::npos) << refused.err;
}

TEST(ErrorBarsOfSweep, AreColumnsAfterTheReadings) {
  const fs::path folder = finger_on_box();
  const std::vector<std::string> sweep{"sweep", "--layout", "fingertip.taxels.json", "--record-every", "1e-3", "--out"};
  std::vector<std::string> plain = sweep, with = sweep;
  plain.push_back("plain");
  with.insert(with.end(), {"with", "--error-bars"});
  EXPECT_EQ(taxel(plain, folder).status, 0);
  const Outcome outcome = taxel(with, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("error [Pa]"), std::string::npos) << outcome.out;
  const std::string before = file_text(folder / "plain/readings.csv"), after = file_text(folder / "with/readings.csv");
  const std::string head = before.substr(0, before.find('\n'));
  EXPECT_EQ(after.substr(0, head.size() + 15), head + ",taxel_0_error,");
  const Json report = Json::parse(file_text(folder / "with/sweep.json"));
  double largest = 0;
  for (const Json& taxel : report["sensors"][0]["taxels"])
    largest = std::max(largest, taxel["largest_error"].get<double>());
  EXPECT_GT(largest, 10);
  EXPECT_FALSE(
      Json::parse(file_text(folder / "plain/sweep.json"))["sensors"][0]["taxels"][0].contains("largest_error"));
}

TEST(ErrorBarsOfSweep, WarnOfASensorThatHasNone) {
  const fs::path folder = finger_on_box(R"([{"op": "add", "path": "/readout/ray", "value": "taxel_normal"}])");
  const Outcome outcome = taxel(
      {"sweep", "--layout", "fingertip.taxels.json", "--record-every", "1e-3", "--error-bars", "--out", "run"}, folder);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("finger: has no error bars: rays along the taxel's normal"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(file_text(folder / "run/readings.csv").find("_error"), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
