// Golden hashes: the same input gives the same bytes with any number of threads and any build type. Only sums, products
// and roots are used to compute these files, so the hashes are the same on every machine.
// After an intended change run TAXEL_UPDATE_GOLDEN=1 test_cli --gtest_filter='Golden*'.
#include <cstdlib>

#include "cli/taxel_program.h"
#include "core/base/files.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const fs::path kGolden = fs::path(TAXEL_SOURCE_DIR) / "tests" / "golden";

/// Compares with golden/NAME, which is written first if the environment asks for it.
void expect_golden(const std::string& name, const Json& found) {
  const fs::path file = kGolden / name;
  if (std::getenv("TAXEL_UPDATE_GOLDEN") != nullptr) write_text(file, found.dump(2) + "\n");
  EXPECT_EQ(found, Json::parse(file_text(file)));
}

TEST(Golden, SamplesFieldsAndContactKeepTheirBytes) {
  const fs::path folder = test_folder();
  fs::copy(kGolden / "finger_on_box.json", folder);
  const fs::path layout =
      changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  fs::rename(layout, folder / "fingertip.taxels.json");
  Json previous;
  for (const char* threads : {"1", "2", "8"}) {
    const auto run = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), {"--quiet", "--threads", threads});
      const Outcome outcome = taxel(arguments, folder);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      return outcome.out;
    };
    run({"samples", "fingertip.taxels.json", "--out", "samples.csv", "--fields", "fields.csv"});
    run({"contact", "finger_on_box.json", "--polygons", "polygons.csv"});
    const std::string read = run({"read", "fingertip.taxels.json", "finger_on_box.json", "--json"});
    Json hashes = {{"read", sha256_hex(read)}};
    for (const char* file : {"samples", "fields", "polygons"}) {
      hashes[file] = sha256_hex(file_text(folder / (std::string(file) + ".csv")));
    }
    if (previous.is_null()) previous = hashes;
    EXPECT_EQ(hashes, previous) << "the number of threads changed the result";
  }
  expect_golden("hashes.json", previous);
}

/// Compares the peaks of all taxels in a sweep with golden/NAME, as numbers, because MuJoCo and libm may differ in the
/// last bit between machines.
void expect_golden_peaks(const std::string& name, const fs::path& sweep) {
  const Json sensor = Json::parse(file_text(sweep / "sweep.json"))["sensors"][0];
  Json peaks = Json::object();
  for (const Json& taxel : sensor["taxels"]) peaks[std::to_string(taxel["id"].get<int>())] = taxel["peak"];
  const fs::path file = kGolden / name;
  if (std::getenv("TAXEL_UPDATE_GOLDEN") != nullptr) write_text(file, peaks.dump(2) + "\n");
  const Json golden = Json::parse(file_text(file));
  ASSERT_EQ(golden.size(), peaks.size());
  for (const auto& [id, peak] : golden.items())
    EXPECT_NEAR(peaks[id].get<double>(), peak.get<double>(), 1e-6 * (peak.get<double>() + 1)) << "taxel " << id;
}

TEST(Golden, KeepsThePeaksOfASweep) {
  expect_golden_peaks("sweep_peaks.json", shared_sweep());
}

TEST(Golden, KeepsThePeaksOfASweepOverABox) {
  expect_golden_peaks("box_sweep_peaks.json", shared_box_sweep());
}

}  // namespace
}  // namespace taxel::test
