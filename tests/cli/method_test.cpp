// --method of taxel read, sweep and run: exact readings of any layout, and samples of a layout that has integrals.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;
using Numbers = std::vector<double>;

constexpr const char *kSamples = "fingertip.taxels.json", *kExact = "exact.taxels.json";

/// Makes a folder with a contact and two layouts that differ in their method only.
fs::path two_layouts() {
  const fs::path folder = finger_on_box();
  Json layout = Json::parse(file_text(folder / kSamples));
  layout["readout"]["method"] = "exact";
  write_text(folder / kExact, layout.dump());
  return folder;
}

Json read_by(const fs::path& folder, const char* layout, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"read", layout, "case.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return taxel_json(arguments, folder);
}

TEST(Method, GivesTheReadingThatTheLayoutWouldGive) {
  const fs::path folder = two_layouts();
  const Json samples = read_by(folder, kSamples), exact = read_by(folder, kExact);
  EXPECT_EQ(samples["method"], "samples");
  EXPECT_EQ(samples["reading"], samples["readings"]["weighted_mean"]);
  EXPECT_EQ(exact["method"], "exact");
  EXPECT_EQ(exact["readings"], samples["readings"]) << "the table of aggregates is always that of the samples";
  EXPECT_EQ(read_by(folder, kSamples, {"--method", "exact"})["reading"], exact["reading"]);
  EXPECT_EQ(read_by(folder, kExact, {"--method", "samples"})["reading"], samples["reading"]);
  const Numbers a = samples["reading"], b = exact["reading"];
  const double peak = *std::max_element(b.begin(), b.end());
  EXPECT_NE(a, b);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 0.05 * peak) << k;
  const Outcome text = taxel({"read", kExact, "case.json"}, folder);
  EXPECT_NE(text.out.find("exact weighted_mean\n"), std::string::npos) << text.out;
}

TEST(Method, IsSamplesForAnAggregateWithoutIntegral) {
  const fs::path folder = two_layouts();
  const Json largest = read_by(folder, kExact, {"--aggregate", "max"});
  EXPECT_EQ(largest["method"], "samples");
  EXPECT_EQ(largest["reading"], largest["readings"]["max"]);
  EXPECT_EQ(read_by(folder, kExact, {"--aggregate", "mean"})["method"], "exact");
  const Outcome refused = taxel({"read", kSamples, "case.json", "--aggregate", "max", "--method", "exact"}, folder);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("\"exact\" is not available for the aggregate \"max\""), std::string::npos) << refused.err;
  const Outcome unknown = taxel({"read", kSamples, "case.json", "--method", "fast"}, folder);
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("must be one of \"samples\", \"exact\", is fast"), std::string::npos) << unknown.err;
}

TEST(Method, ReadsASweepByIntegrals) {
  const fs::path folder = two_layouts();
  const auto sweep = [&](const char* layout, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"sweep", "--layout", layout, "--record-every", "2e-3", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return file_text(folder / "out/readings.csv");
  };
  const std::string exact = sweep(kExact, {});
  EXPECT_EQ(sweep(kSamples, {"--method", "exact"}), exact);
  EXPECT_NE(sweep(kSamples, {}), exact);
}

TEST(Method, AppliesToEveryLayoutOfAScene) {
  const fs::path folder = two_layouts();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj", folder);
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run",       "scene.xml", "--layout", kSamples, "--geom", "tip",
                                       "--seconds", "0.01",      "--quiet",  "--out",  "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taxel(arguments, folder);
  };
  EXPECT_EQ(run({"--method", "exact"}).status, 0);
  EXPECT_EQ(Json::parse(file_text(folder / "out/sensor_0.taxels.json"))["readout"]["method"], "exact");
  const Outcome refused = run({"--method", "exact", "--aggregate", "nearest"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("is not available for the aggregate \"nearest\""), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace taxel::test
