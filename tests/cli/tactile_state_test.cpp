// `--tactile-state` writes the readings as messages of tactile_msgs/TactileState as well.
#include <sstream>

#include "cli/taxel_program.h"
#include "fixtures/finger_scene_xml.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

TEST(TactileState, HasOneMessagePerRowAndSensor) {
  const fs::path folder = test_folder();
  fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
  changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                         {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
  write_text(folder / "scene.xml", finger_scene(finger_body("thumb", 0) + finger_body("index", 0.1), {"thumb", "index"},
                                                "changed.taxels.json"));
  const Json run = taxel_json({"run", "scene.xml", "--seconds", "0.004", "--out", "out", "--tactile-state"}, folder);
  EXPECT_NE(run["files"].dump().find("tactile_state.jsonl"), std::string::npos);
  const Table table = read_csv(folder / "out/readings.csv");
  std::istringstream lines(file_text(folder / "out/tactile_state.jsonl"));
  std::size_t row = 0;
  for (std::string line; std::getline(lines, line); ++row) {
    const Json message = Json::parse(line);
    const Json& stamp = message["header"]["stamp"];
    EXPECT_NEAR(stamp["secs"].get<double>() + 1e-9 * stamp["nsecs"].get<double>(), table.at("time")[row], 1e-9);
    ASSERT_EQ(message["sensors"].size(), 2U);
    EXPECT_EQ(message["sensors"][1]["name"], "index");
    for (int id = 0; id < 12; ++id) {
      const auto reading = static_cast<float>(table.at("index/taxel_" + std::to_string(id))[row]);
      EXPECT_EQ(message["sensors"][1]["values"][static_cast<std::size_t>(id)].get<float>(), reading);
    }
  }
  EXPECT_EQ(row, table.at("time").size());
  EXPECT_GE(row, 2U);
  // The file has the messages of this run only.
  taxel_json({"run", "scene.xml", "--seconds", "0.004", "--out", "out"}, folder);
  EXPECT_FALSE(fs::exists(folder / "out/tactile_state.jsonl"));
  expect_refusal(taxel({"run", "scene.xml", "--tactile-state"}, folder), "taxel: run: --tactile-state requires --out");
}

}  // namespace
}  // namespace taxel::test
