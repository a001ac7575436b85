// `taxel read --convergence`: the same contact with fewer and with more samples.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

fs::path contact_folder() {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "tests" / "golden" / "finger_on_box.json", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  return folder;
}

// Each of the three readings equals, to the last bit, that of a layout with this density. Without the option nothing
// changes.
TEST(ConvergenceOption, EqualsReadingsAtTheListedDensities) {
  const fs::path folder = contact_folder();
  const auto read = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"read", "changed.taxels.json", "finger_on_box.json", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return taxel_json(arguments, folder);
  };
  for (const char* how : {"weighted_mean", "max"}) {
    Json with = read({"--aggregate", how, "--convergence"});
    const Json convergence = with["convergence"];
    with.erase("convergence");
    EXPECT_EQ(with, read({"--aggregate", how}));
    EXPECT_EQ(convergence["aggregate"], how);
    EXPECT_EQ(convergence["factors"], Json::parse("[0.25, 1, 4]"));
    ASSERT_EQ(convergence["taxels"].size(), 12U);
    const char* densities[] = {"2.5e5", "1e6", "4e6"};
    double moved = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Json alone = read({"--density", densities[i]})["readings"][how];
      const Json counts = taxel_json(
          {"samples", "changed.taxels.json", "--density", densities[i], "--quiet", "--out", "s.csv"}, folder);
      EXPECT_EQ(convergence["samples"][i], counts["samples"]);
      for (std::size_t k = 0; k < 12; ++k) {
        const Json& taxel = convergence["taxels"][k];
        EXPECT_EQ(taxel["id"], with["taxels"][k]["id"]);
        EXPECT_EQ(taxel["values"][i], alone[k]) << how << " taxel " << k << " density " << densities[i];
        const double difference = taxel["values"][2].get<double>() - taxel["values"][1].get<double>();
        EXPECT_EQ(taxel["difference"], difference);
        moved += std::abs(difference);
      }
    }
    EXPECT_GT(moved, 1.0);
  }
}

TEST(ConvergenceOption, AddsItsTableToTheText) {
  const fs::path folder = contact_folder();
  const std::vector<std::string> plain{"read", "changed.taxels.json", "finger_on_box.json", "--quiet"};
  std::vector<std::string> asked = plain;
  asked.emplace_back("--convergence");
  const std::string before = taxel(plain, folder).out, after = taxel(asked, folder).out;
  ASSERT_TRUE(after.starts_with(before)) << after;
  EXPECT_NE(after.find("weighted_mean with 1/4, 1 and 4 times the samples"), std::string::npos) << after;
  EXPECT_EQ(std::count(after.begin(), after.end(), '\n'), std::count(before.begin(), before.end(), '\n') + 3 + 12);
}

}  // namespace
}  // namespace taxel::test
