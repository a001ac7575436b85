// The paper's formula and the formula of its released code on the same contact, chosen in the layout or on the command
// line.
#include <cmath>
#include <map>

#include "cli/taxel_program.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr double kRounding = 1e-12;

Json density_and(Json more) {
  more.push_back({{"op", "replace"}, {"path", "/sampling/density"}, {"value", 1e6}});
  return more;
}
Json aggregate_patch(const char* word) {
  return Json::array({{{"op", "replace"}, {"path", "/readout/aggregate"}, {"value", word}}});
}

/// Makes a folder with a contact of the finger and a coarse layout.
fs::path contact_folder() {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "tests" / "golden" / "finger_on_box.json", folder);
  changed_layout(folder, density_and(Json::array()));
  return folder;
}

/// Returns the sum of w = (r - d)^2 over the samples of each taxel, from the file of the fields.
std::map<int, double> weight_sums(const fs::path& folder) {
  taxel_json({"samples", "changed.taxels.json", "--fields", "fields.csv"}, folder);
  const Table fields = read_csv(folder / "fields.csv");
  std::map<int, double> sums;
  for (std::size_t e = 0; e < fields.at("taxel").size(); ++e)
    sums[static_cast<int>(fields.at("taxel")[e])] += std::pow(0.006 - fields.at("distance")[e], 2);
  return sums;
}

// Expected: sum w p / sum w (the paper) and sum w p (its released code) from the same samples and hits.
TEST(ReleasedCode, ReadsThePapersMeanTimesTheSumOfWeights) {
  const fs::path folder = contact_folder();
  const Json read = taxel_json({"read", "changed.taxels.json", "finger_on_box.json"}, folder);
  std::map<int, double> weights = weight_sums(folder);
  int pressed = 0;
  for (std::size_t k = 0; k < read["taxels"].size(); ++k) {
    const Json& taxel = read["taxels"][k];
    double sum = 0;
    for (const Json& s : taxel["samples"]) sum += s["weight"].get<double>() * s["pressure"].get<double>();
    const double paper = read["readings"]["weighted_mean"][k], released = read["readings"]["weighted_sum"][k];
    const double divisor = weights[taxel["id"]];
    EXPECT_NEAR(released, sum, kRounding * sum);
    EXPECT_NEAR(paper, sum / divisor, kRounding * paper);
    EXPECT_NEAR(released, paper * divisor, kRounding * released);
    pressed += paper > 100 && released > 0 && released < 0.1 * paper;  // the weights add up to (6 mm)^2 times a hundred
  }
  EXPECT_GE(pressed, 4);
}

// With more samples the paper's reading stays equal; that of the released code grows with their number.
TEST(ReleasedCode, GrowsWithTheSampleDensityUnlikeThePaper) {
  const fs::path folder = contact_folder();
  const auto at = [&](const char* density) {
    return taxel_json({"read", "changed.taxels.json", "finger_on_box.json", "--density", density}, folder)["readings"];
  };
  const Json few = at("2e6"), many = at("8e6");
  const auto largest = [](const Json& values) {
    return std::max_element(values.begin(), values.end()) - values.begin();
  };
  const auto k = static_cast<std::size_t>(largest(few["weighted_mean"]));
  const auto ratio = [&](const char* how) { return many[how][k].get<double>() / few[how][k].get<double>(); };
  EXPECT_NEAR(ratio("weighted_mean"), 1.0, 0.1);
  EXPECT_NEAR(ratio("weighted_sum"), 4.0, 0.4);
}

TEST(ReleasedCode, GivesTheSameBytesByOptionAndByLayout) {
  const fs::path folder = contact_folder();
  const auto read = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"read", "changed.taxels.json", "finger_on_box.json", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string paper = read({}), released = read({"--aggregate", "weighted_sum"});
  EXPECT_EQ(Json::parse(paper)["aggregate"], "weighted_mean");
  EXPECT_EQ(Json::parse(released)["aggregate"], "weighted_sum");
  EXPECT_EQ(Json::parse(paper)["readings"], Json::parse(released)["readings"]);
  changed_layout(folder, density_and(aggregate_patch("weighted_sum")));
  EXPECT_EQ(read({}), released);
  EXPECT_EQ(read({"--aggregate", "weighted_mean"}), paper) << "the option goes over the layout";
}

/// Expects each reading of `released` to be that of `paper` times the taxel's sum of weights, and all else to be equal.
void expect_released(const Table& paper, const Table& released, std::map<int, double> weights) {
  double largest = 0;
  for (const auto& [head, values] : paper) {
    if (!head.starts_with("taxel_")) {
      EXPECT_EQ(released.at(head), values) << head;
      continue;
    }
    const double divisor = weights[std::stoi(head.substr(6))];
    for (std::size_t row = 0; row < values.size(); ++row) {
      const double expected = values[row] * divisor;
      EXPECT_NEAR(released.at(head)[row], expected, kRounding * expected) << head << " row " << row;
      largest = std::max(largest, values[row]);
    }
  }
  EXPECT_GT(largest, 100);
}

TEST(ReleasedCode, ScalesTheReadingsOfASweepByTheSumOfWeights) {
  const fs::path folder = contact_folder();
  const auto sweep = [&](const char* aggregate, const char* out) {
    const Outcome outcome = taxel({"sweep", "--layout", "changed.taxels.json", "--aggregate", aggregate, "--out", out,
                                   "--record-every", "0.002", "--object", "box", "--quiet"},
                                  folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_csv(folder / out / "readings.csv");
  };
  const Table paper = sweep("weighted_mean", "paper"), released = sweep("weighted_sum", "released");
  expect_released(paper, released, weight_sums(folder));
}

// The option replaces the aggregate of every layout, declared in the scene or attached, also in the written folder.
TEST(ReleasedCode, ReplacesTheAggregateOfEveryLayoutInAScene) {
  const fs::path folder = contact_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const auto run = [&](const std::vector<std::string>& options, const char* out) {
    std::vector<std::string> arguments{"run", "--seconds", "0.01", "--quiet", "--out", out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_csv(folder / out / "readings.csv");
  };
  const std::map<int, double> weights = weight_sums(folder);
  const std::vector<std::string> attached{"scene.xml", "--layout", "changed.taxels.json", "--geom", "tip"};
  std::vector<std::string> switched = attached;
  switched.insert(switched.end(), {"--aggregate", "weighted_sum"});
  const Table paper = run(attached, "paper"), released = run(switched, "released");
  expect_released(paper, released, weights);
  const Json written = Json::parse(file_text(folder / "released" / "sensor_0.taxels.json"));
  EXPECT_EQ(written["readout"]["aggregate"], "weighted_sum");
  expect_released(run({"paper/scene.xml"}, "a"), run({"paper/scene.xml", "--aggregate", "weighted_sum"}, "b"), weights);
}

// The integral needs data that samples do not need; a model that is switched to the integral must have it.
TEST(Aggregates, GiveTheSameForceByOptionAndByLayout) {
  const fs::path folder = contact_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const auto run = [&](const std::vector<std::string>& options, const char* out) {
    std::vector<std::string> arguments{"run",     "scene.xml", "--layout",  "changed.taxels.json",
                                       "--geom",  "tip",       "--seconds", "0.01",
                                       "--quiet", "--out",     out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_csv(folder / out / "readings.csv");
  };
  const Table switched = run({"--aggregate", "force"}, "switched");
  changed_layout(folder, density_and(aggregate_patch("force")));
  EXPECT_EQ(switched, run({}, "layout"));
  double felt = 0;
  for (const auto& [head, values] : switched) {
    if (head.starts_with("taxel_")) felt += *std::max_element(values.begin(), values.end());
  }
  EXPECT_GT(felt, 0);
}

}  // namespace
}  // namespace taxel::test
