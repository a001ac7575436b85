// The chain of a taxel on the command line: taxel read with and without --ideal, taxel run, taxel check.
#include <algorithm>
#include <cmath>
#include <map>

#include "cli/taxel_program.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;
using Numbers = std::vector<double>;

/// Writes a layout with a calibration as device.taxels.json next to another layout.
void write_device(const fs::path& folder, const char* layout, const Json& calibration) {
  Json json = Json::parse(file_text(folder / layout));
  json["calibration"] = calibration;
  write_text(folder / "device.taxels.json", json.dump());
}

/// Makes a folder with the fingertip's mesh and a coarse layout on it, changed.taxels.json.
fs::path folder_of_coarse_finger() {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                         {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  return folder;
}

TEST(Calibrated, ReadsAContactAtRestThroughTheChain) {
  const fs::path folder = finger_on_box();
  Json chain = {{"unit", "V"},
                {"response", {{"polynomial", {1e-3, 2e-9}}, {"up_to", 1e6}}},
                {"relaxation", {{{"amplitude", 0.5}, {"time", 1e-6}}}},
                {"low_pass", {{"time", 5}}},
                {"tare", "first_reading"},
                {"gain", 2},
                {"rate", 10},
                {"latency", 0.1}};
  write_device(folder, "fingertip.taxels.json", chain);
  const Json with = taxel_json({"read", "device.taxels.json", "case.json"}, folder);
  const Json ideal = taxel_json({"read", "device.taxels.json", "case.json", "--ideal"}, folder);
  const Json plain = taxel_json({"read", "fingertip.taxels.json", "case.json"}, folder);
  EXPECT_EQ(ideal, plain);
  EXPECT_EQ(with["reading"], plain["reading"]);
  EXPECT_EQ(with["calibrated"]["unit"], "V");
  const Numbers x = plain["reading"], values = with["calibrated"]["values"];
  ASSERT_EQ(values.size(), x.size());
  EXPECT_GT(*std::max_element(values.begin(), values.end()), 0.01);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(values[k], 2 * (1e-3 * x[k] + 2e-9 * x[k] * x[k]), 1e-9) << k;
  const Outcome text = taxel({"read", "device.taxels.json", "case.json"}, folder);
  EXPECT_NE(text.out.find("values that a device with the layout's calibration reports at rest [V]"), std::string::npos)
      << text.out;
  EXPECT_EQ(taxel({"read", "device.taxels.json", "case.json", "--ideal"}, folder).out.find("device"),
            std::string::npos);
}

TEST(Calibrated, DelaysAndRelaxesTheValuesOfARun) {
  const fs::path folder = folder_of_coarse_finger();
  write_text(folder / "scene.xml", finger_scene(finger_body("tip", 0, true, "<freejoint/>")));
  const auto run = [&](const Json& calibration) {
    write_device(folder, "changed.taxels.json", calibration);
    taxel_json(
        {"run", "scene.xml", "--layout", "device.taxels.json", "--geom", "tip", "--seconds", "0.03", "--out", "out"},
        folder);
    return read_csv(folder / "out" / "calibrated.csv");
  };
  const Table relaxed = run({{"relaxation", {{{"amplitude", 0.3}, {"time", 0.01}}}}});
  const Table raw = read_csv(folder / "out" / "readings.csv");
  const Numbers &time = raw.at("time"), &x = raw.at("taxel_0"), &y = relaxed.at("taxel_0");
  ASSERT_GT(time.size(), 5U);
  const double peak = *std::max_element(x.begin(), x.end());
  EXPECT_GT(peak, 0);
  double z = 0;  // of tau dz/dt = 0.3 x - z, by many small steps along straight lines between readings
  for (std::size_t i = 1; i < time.size(); ++i) {
    const int parts = 4000;
    const double h = (time[i] - time[i - 1]) / parts;
    for (int p = 0; p < parts; ++p) {
      const double middle = x[i - 1] + (x[i] - x[i - 1]) * (p + 0.5) / parts;
      z += (0.3 * middle - z) * h / 0.01;
    }
    EXPECT_NEAR(y[i], x[i] - z, 3e-5 * peak) << i;  // the sum has an error of h / 2 tau
  }
  const Table late = run({{"latency", 2.2 * (time[1] - time[0])}});
  const Numbers& delayed = late.at("taxel_0");
  for (std::size_t i = 0; i < delayed.size(); ++i) EXPECT_EQ(delayed[i], x[i < 2 ? 0 : i - 2]) << i;
}

TEST(Calibrated, HasTheSameNoiseInABatchOfAnyThreads) {
  const fs::path folder = folder_of_coarse_finger();
  write_device(folder, "changed.taxels.json", {{"noise", 3}, {"relaxation", {{{"amplitude", 0.1}, {"time", 0.5}}}}});
  const Json job = {{"layout", "device.taxels.json"},
                    {"scenario", {{"kind", "press"}}},
                    {"set", {{"/layout/calibration/latency", {{"values", {0, 0.02}}}}}}};
  write_text(folder / "jobs.jsonl", job.dump() + "\n");
  const auto shards = [&](const char* threads, const char* out) {
    const Outcome outcome = taxel({"batch", "jobs.jsonl", "--out", out, "--threads", threads}, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::map<std::string, std::string> bytes;
    for (const auto& entry : fs::directory_iterator(folder / out / "shards"))
      bytes[entry.path().filename().string()] = file_text(entry.path());
    return bytes;
  };
  const auto one = shards("1", "one"), two = shards("2", "two");
  ASSERT_EQ(one.size(), 2U);
  EXPECT_EQ(one, two);
  EXPECT_NE(one.begin()->second.find("observation.calibrated"), std::string::npos);
}

TEST(Calibrated, NamesTheFieldOfAWrongStage) {
  const fs::path folder = finger_on_box();
  const auto refuse = [&](const Json& calibration, const std::string& message) {
    write_device(folder, "fingertip.taxels.json", calibration);
    const Outcome outcome = taxel({"check", "device.taxels.json"}, folder);
    EXPECT_NE(outcome.status, 0);
    EXPECT_NE((outcome.out + outcome.err).find(message), std::string::npos) << outcome.out << outcome.err;
  };
  refuse({{"relaxation", {{{"amplitude", 0.1}, {"time", -2}}}}},
         "/calibration/relaxation/0/time: error: must be greater than 0, is -2");
  refuse({{"response", {{"points", {{0, 0}, {2, 5}, {3, 4}}}}}},
         "/calibration/response/points/2/1: error: must be 5 or more, as before it, is 4");
  refuse({{"crosstalk_matrix", {{1}}}}, "/calibration/crosstalk_matrix: error: must have 12 rows, has 1");
  refuse({{"latency", -0.1}}, "/calibration/latency: error: must be 0 or more, is -0.1");
}

}  // namespace
}  // namespace taxel::test
