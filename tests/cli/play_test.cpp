// `taxel play`: every kind of scenario from end to end, and a replay that repeats its original run.
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Runs `taxel play` with this scenario and few samples. Returns the folder of the recording.
fs::path play(const fs::path& folder, const std::string& name, const Json& scenario) {
  const fs::path file = folder / (name + ".json");
  write_text(file, Json{{"format", "taxel-scenario"}, {"version", 1}, {"scenario", scenario}}.dump());
  const Outcome outcome =
      taxel({"play", file.string(), "--density", "1e5", "--quiet", "--out", (folder / name).string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return folder / name;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

double largest_reading(const Table& table) {
  double most = 0;
  for (int id = 0; id < 12; ++id) most = std::max(most, largest(table.at("taxel_" + std::to_string(id))));
  return most;
}

using Arrays = decltype(parse_npz(""));
Arrays arrays_of(const fs::path& folder) {
  return parse_npz(file_text(folder / "readings.npz"));
}

TEST(Play, PressesToTheDepthWithAFingerThatFollows) {
  const fs::path folder = test_folder();
  const fs::path out = play(folder, "press", {{"kind", "press"}, {"tilt_deg", 0}, {"depth", 0.001}, {"hold", 0.3}});
  const Arrays arrays = arrays_of(out);
  const std::vector<double> mocap = arrays.at("mocap_pos").doubles(), sensor = arrays.at("sensor_pos").doubles();
  const std::vector<std::int64_t> step = arrays.at("step").integers();
  double lowest = 1, lag = 0;
  for (std::size_t i = 2; i < mocap.size(); i += 3) lowest = std::min(lowest, mocap[i]);
  EXPECT_NEAR(mocap[2] - lowest, 0.002, 1e-12);  // 1 mm of clearance, 1 mm deep
  for (std::size_t r = 0; r < step.size(); ++r)
    lag = std::max(lag, std::abs(sensor[3 * r + 2] - mocap[3 * static_cast<std::size_t>(step[r]) + 2]));
  EXPECT_LT(lag, 0.1e-3) << "finger behind the mocap body";
  const Table table = read_csv(out / "readings.csv");
  const std::vector<double>& force = table.at("force_z");
  EXPECT_EQ(force.front(), 0);
  EXPECT_EQ(force.back(), 0);
  EXPECT_GT(largest(force), 0.1);
  EXPECT_GT(largest_reading(table), 0);
  const Json told = Json::parse(file_text(out / "scenario.json"));
  EXPECT_EQ(told["format"], "taxel-play");
  EXPECT_EQ(told["scenario"]["kind"], "press");
  EXPECT_EQ(taxel({"check", (out / "scenario.json").string(), (folder / "press.json").string()}).status, 0);
}

TEST(Play, TurnsATwistedFingerAgainstTorsion) {
  const fs::path out =
      play(test_folder(), "twist", {{"kind", "twist"}, {"tilt_deg", 0}, {"hold", 0}, {"angle_deg", 20}});
  const std::vector<double> quat = arrays_of(out).at("sensor_quat").doubles();
  double turned = 0;
  for (std::size_t r = 0; r + 3 < quat.size(); r += 4) {
    double dot = 0;
    for (std::size_t k = 0; k < 4; ++k) dot += quat[k] * quat[r + k];
    turned = std::max(turned, 2 * std::acos(std::min(1.0, std::abs(dot))) * 180 / 3.14159265358979);
  }
  EXPECT_NEAR(turned, 20, 1);
  EXPECT_GT(largest_reading(read_csv(out / "readings.csv")), 0);
}

TEST(Play, MovesPressureAcrossTaxelsByRollAndSlide) {
  for (const char* kind : {"roll", "slide"}) {
    const fs::path out = play(test_folder(), kind, {{"kind", kind}, {"tilt_deg", 20}, {"hold", 0}, {"shape", "plate"}});
    const Table table = read_csv(out / "readings.csv");
    EXPECT_GT(largest_reading(table), 0) << kind;
    const std::vector<double>& force = table.at("force_x");
    EXPECT_GT(largest(force), 0) << kind;  // friction in both directions
    EXPECT_LT(*std::min_element(force.begin(), force.end()), 0) << kind;
    const Arrays arrays = arrays_of(out);
    const std::vector<double> pos = arrays.at("mocap_pos").doubles(), quat = arrays.at("mocap_quat").doubles();
    const Json scenario = Json::parse(file_text(out / "scenario.json"))["scenario"];
    double way = 0, turn = 0;
    for (std::size_t step = 0; 3 * step < pos.size(); ++step) {
      double dot = 0;
      for (std::size_t k = 0; k < 4; ++k) dot += quat[k] * quat[4 * step + k];
      way = std::max(way, std::hypot(pos[3 * step] - pos[0], pos[3 * step + 1] - pos[1]));
      turn = std::max(turn, 2 * std::acos(std::min(1.0, std::abs(dot))) * 180 / 3.14159265358979);
    }
    if (std::string(kind) == "slide") {
      EXPECT_NEAR(way, scenario["distance"].get<double>(), 1e-9);
      EXPECT_LT(turn, 1e-5);
    } else {
      EXPECT_NEAR(turn, std::abs(scenario["angle_deg"].get<double>()), 0.5);
      EXPECT_GT(way, 1e-3);
    }
  }
}

TEST(Play, DropsAnObjectWithTheAccelerationOfGravity) {
  const fs::path out =
      play(test_folder(), "drop",
           {{"kind", "drop"}, {"height", 0.01}, {"duration", 0.1}, {"shape", "sphere"}, {"tilt_deg", 10}});
  const Arrays arrays = arrays_of(out);
  const std::vector<double> time = arrays.at("time").doubles(), pos = arrays.at("sensor_pos").doubles();
  const Table table = read_csv(out / "readings.csv");
  const std::vector<double>& force = table.at("force_z");
  ASSERT_EQ(time.size(), 11U);
  for (std::size_t r = 0; r < 5; ++r) {  // semi-implicit Euler: -g t (t + dt) / 2
    EXPECT_NEAR(pos[3 * r + 2] - pos[2], -9.81 * 0.5 * time[r] * (time[r] + 0.001), 1e-9);
    EXPECT_EQ(force[r], 0);
  }
  EXPECT_GT(largest(force), 0.2);  // the weight is 0.2 N
}

TEST(Play, MovesTheMocapBodyAlongAPath) {
  const Json up = {0.6, 0, 0.8, 0}, turned = {0.8, 0, 0.6, 0};
  const fs::path out = play(test_folder(), "path",
                            {{"kind", "path"},
                             {"points",
                              {{{"time", 0}, {"pos", {0.02, 0, 0.1}}, {"quat", up}},
                               {{"time", 0.05}, {"pos", {0.03, 0, 0.09}}, {"quat", turned}},
                               {{"time", 0.1}, {"pos", {0.03, 0.01, 0.09}}, {"quat", turned}}}}});
  const Arrays arrays = arrays_of(out);
  const std::vector<double> pos = arrays.at("mocap_pos").doubles(), quat = arrays.at("mocap_quat").doubles();
  ASSERT_EQ(pos.size(), 3 * 101U);
  for (const auto& [step, p] : {std::pair<std::size_t, std::vector<double>>{0, {0.02, 0, 0.1}},
                                {50, {0.03, 0, 0.09}},
                                {100, {0.03, 0.01, 0.09}}})
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(pos[3 * step + k], p[k], 1e-15) << step;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(quat[200 + k], turned[k].get<double>(), 1e-15);
}

TEST(Play, ReplaysARunBitForBit) {
  const Json slow = {{"before", 0.003}, {"past", 0.002}};
  const fs::path folder = test_folder();
  const fs::path sweep = play(folder, "sweep", slow);
  const fs::path twist = play(folder, "twist", {{"kind", "twist"}, {"hold", 0}, {"angle_deg", 10}, {"tilt_deg", 30}});
  for (const fs::path& run : {sweep, twist}) {
    const fs::path again = play(folder, "replay", {{"kind", "replay"}, {"source", run.filename().string()}});
    const Arrays a = arrays_of(run), b = arrays_of(again);
    for (const char* name :
         {"readings", "force", "area", "sensor_pos", "sensor_quat", "time", "mocap_pos", "mocap_quat"})
      EXPECT_EQ(a.at(name).data, b.at(name).data) << run << " " << name;
    EXPECT_GT(largest(a.at("readings").doubles()), 0);
  }
}

TEST(Play, ReportsALayoutWithoutAName) {
  const fs::path folder = test_folder();
  write_text(folder / "drop.json", R"({"kind": "drop", "duration": 0.005})");
  const fs::path layout = changed_layout(folder, Json::parse(R"([{"op": "remove", "path": "/name"}])"));
  const Outcome outcome = taxel({"play", "drop.json", "--layout", layout.string(), "--density", "1e5"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("drop of a layout without a name: ", 0), 0U) << outcome.out;
}

TEST(Play, NamesBadInput) {
  const fs::path folder = test_folder();
  const auto complaint = [&](const Json& scenario) {
    write_text(folder / "bad.json", scenario.dump());
    const Outcome outcome = taxel({"play", "bad.json"}, folder);
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  };
  EXPECT_EQ(complaint({{"kind", "press"}, {"depth", -1}}), "taxel: bad.json: /depth: must be greater than 0, is -1\n");
  EXPECT_NE(complaint({{"kind", "replay"}, {"source", "nowhere"}}).find("nowhere: no such file"), std::string::npos);
  EXPECT_NE(complaint({{"kind", "press"}, {"hold", 9e5}}).find("steps"), std::string::npos);
  const fs::path drop = play(folder, "drop", {{"kind", "drop"}, {"duration", 0.01}});
  EXPECT_NE(complaint({{"kind", "replay"}, {"source", "drop"}}).find("no mocap body moved in that run"),
            std::string::npos);
  write_text(folder / "press.json", R"({"kind": "press"})");
  EXPECT_EQ(taxel({"sweep", "--scenario", "press.json"}, folder).err,
            "taxel: press.json: is a scenario of the kind \"press\": `taxel play` runs it\n");
}

}  // namespace
}  // namespace taxel::test
