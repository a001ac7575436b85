// Recordings: every number is read back exactly, columns and arrays have the documented names, and the bytes are
// reproducible.
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "core/run/recording/recording.h"
#include "core/run/recording/recording_files.h"
#include "fixtures/read_npz.h"

namespace taxel {
namespace {

/// Returns a recording of two rows, one step apart in the second half of the mocap list, with numbers without a short
/// decimal form.
Recording make_recording(int sensors) {
  Recording recording;
  recording.timestep = 0.001;
  recording.objects = {"box"};
  for (int s = 0; s < sensors; ++s) {
    recording.sensors.push_back({s == 0 ? "finger" : "thumb, left",
                                 {7, 3},
                                 {"tip",
                                  "p\xc3\xa4"
                                  "d"},
                                 "{\"x\": 1}",
                                 "Pa",
                                 42});
  }
  for (int i = 0; i < 4; ++i) recording.mocap.push_back({dquat(1, 0, 0, 0), dvec3(0.1 * i, 0, 1.0 / 3.0)});
  for (int r = 0; r < 2; ++r) {
    RecordedRow row{2 * r, r / 3.0, r * 1e-4, {}, {Pose{dquat(0, 1, 0, 0), dvec3(r, 2, 3)}}};
    for (int s = 0; s < sensors; ++s) {
      row.sensors.push_back({dvec3(0.1 + 0.2, -1e-300, r),
                             std::nextafter(1.0, 2.0),
                             17 + s,
                             {1e22 * r, std::sqrt(2.0)},
                             Pose{dquat(0.6, 0.8, 0, 0), dvec3(s, r, 0.1)}});
    }
    recording.rows.push_back(row);
  }
  return recording;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(RecordingCsv, HasTheDocumentedHeader) {
  EXPECT_EQ(lines_of(recording_to_csv(make_recording(1)))[0],
            "time,travel,force_x,force_y,force_z,area,polygons,taxel_7,taxel_3");
  EXPECT_EQ(
      lines_of(recording_to_csv(make_recording(2)))[0],
      "time,travel,finger/force_x,finger/force_y,finger/force_z,finger/area,finger/polygons,finger/taxel_7,"
      "finger/taxel_3,\"thumb, left/force_x\",\"thumb, left/force_y\",\"thumb, left/force_z\",\"thumb, left/area\","
      "\"thumb, left/polygons\",\"thumb, left/taxel_7\",\"thumb, left/taxel_3\"");
}

TEST(RecordingCsv, WritesTheShortestNumbersThatReadBackExactly) {
  const Recording recording = make_recording(1);
  const std::vector<std::string> lines = lines_of(recording_to_csv(recording));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1], "0,0,0.30000000000000004,-1e-300,0,1.0000000000000002,17,0,1.4142135623730951");
  std::vector<double> values;
  std::istringstream in(lines[2]);
  for (std::string field; std::getline(in, field, ',');) {
    double value = 0;
    const auto [end, code] = std::from_chars(field.data(), field.data() + field.size(), value);
    EXPECT_EQ(end, field.data() + field.size());
    values.push_back(value);
  }
  const SensorRecord& record = recording.rows[1].sensors[0];
  const std::vector<double> expected{1.0 / 3.0, 1e-4, record.force_W.x, record.force_W.y, record.force_W.z, record.area,
                                     17,        1e22, std::sqrt(2.0)};
  EXPECT_EQ(values, expected);
}

TEST(RecordingNpz, ContainsEveryArrayWithItsShape) {
  const Recording recording = make_recording(1);
  auto arrays = test::parse_npz(recording_to_npz(recording));
  EXPECT_EQ(arrays["time"].doubles(), (std::vector<double>{0, 1.0 / 3.0}));
  EXPECT_EQ(arrays["step"].integers(), (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(arrays["force"].shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(arrays["force"].doubles(), (std::vector<double>{0.1 + 0.2, -1e-300, 0, 0.1 + 0.2, -1e-300, 1}));
  EXPECT_EQ(arrays["readings"].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(arrays["readings"].doubles(), (std::vector<double>{0, std::sqrt(2.0), 1e22, std::sqrt(2.0)}));
  EXPECT_EQ(arrays["polygons"].integers(), (std::vector<std::int64_t>{17, 17}));
  EXPECT_EQ(arrays["sensor_quat"].doubles(), (std::vector<double>{0.6, 0.8, 0, 0, 0.6, 0.8, 0, 0}));
  EXPECT_EQ(arrays["object_pos"].shape, (std::vector<std::size_t>{2, 1, 3}));
  EXPECT_EQ(arrays["object_names"].texts(), std::vector<std::string>{"box"});
  EXPECT_EQ(arrays["mocap_pos"].shape, (std::vector<std::size_t>{4, 3}));
  EXPECT_EQ(arrays["mocap_quat"].shape, (std::vector<std::size_t>{4, 4}));
  EXPECT_EQ(arrays["taxel_ids"].integers(), (std::vector<std::int64_t>{7, 3}));
  EXPECT_EQ(arrays["layout"].texts(), std::vector<std::string>{"{\"x\": 1}"});
  EXPECT_EQ(arrays["seed"].integers(), std::vector<std::int64_t>{42});
  EXPECT_TRUE(arrays["timestep"].shape.empty());
}

TEST(Recording, StoresTheSlipOfSensorsWhoseFrictionSticks) {
  EXPECT_EQ(slip_to_csv(make_recording(2)), "");
  Recording recording = make_recording(2);
  recording.sensors[1].slip = true;
  for (RecordedRow& row : recording.rows) row.sensors[1].slip = {0.25, 1.0 / 3.0};
  const std::vector<std::string> lines = lines_of(slip_to_csv(recording));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "time,travel,\"thumb, left/taxel_7\",\"thumb, left/taxel_3\"");
  EXPECT_NE(lines[1].find(",0.25,0.3333333333333333"), std::string::npos) << lines[1];
  auto arrays = test::parse_npz(recording_to_npz(recording));
  EXPECT_EQ(arrays["thumb, left/slip"].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_FALSE(arrays.contains("finger/slip"));
}

/// Two sensors; the second reads by force and with shear.
TEST(Recording, StoresShearAndTheUncoveredForceSeparately) {
  EXPECT_EQ(shear_to_csv(make_recording(2)), "");
  Recording recording = make_recording(2);
  const std::string plain = recording_to_csv(recording);
  RecordedSensor& sensor = recording.sensors[1];
  sensor.force = sensor.shear = true;
  sensor.tangents = {{dvec3(1, 0, 0), dvec3(0, 1, 0)}, {dvec3(0, 0, 1), dvec3(1, 0, 0)}};
  for (RecordedRow& row : recording.rows) {
    row.sensors[1].shear = {dvec2(row.travel, -1.0 / 3.0), dvec2(0, 2)};
    row.sensors[1].uncovered_W = dvec3(0, 0, 0.5);
    row.sensors[1].elastic_force_W = dvec3(0, 0.25, 2);
  }
  EXPECT_EQ(recording_to_csv(recording), plain) << "the columns of readings.csv are fixed";
  const std::vector<std::string> lines = lines_of(shear_to_csv(recording));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            "time,travel,\"thumb, left/taxel_7_e1\",\"thumb, left/taxel_7_e2\",\"thumb, left/taxel_3_e1\","
            "\"thumb, left/taxel_3_e2\"");
  EXPECT_NE(lines[1].find(",-0.3333333333333333,0,2"), std::string::npos) << lines[1];
  auto arrays = test::parse_npz(recording_to_npz(recording));
  EXPECT_EQ(arrays["thumb, left/shear"].shape, (std::vector<std::size_t>{2, 2, 2}));
  EXPECT_EQ(arrays["thumb, left/tangents"].shape, (std::vector<std::size_t>{2, 2, 3}));
  EXPECT_EQ(arrays["thumb, left/uncovered"].doubles(), (std::vector<double>{0, 0, 0.5, 0, 0, 0.5}));
  EXPECT_FALSE(arrays.contains("finger/shear"));
  EXPECT_FALSE(arrays.contains("finger/uncovered"));
  EXPECT_EQ(arrays["thumb, left/elastic_force"].doubles(), (std::vector<double>{0, 0.25, 2, 0, 0.25, 2}));
  EXPECT_FALSE(arrays.contains("finger/elastic_force"));  // as in recordings of older versions
}

/// Returns a recording of two sensors; the second is calibrated.
Recording calibrated_recording() {
  Recording recording = make_recording(2);
  recording.sensors[1].calibrated_unit.emplace("V");
  for (RecordedRow& row : recording.rows) row.sensors[1].calibrated = {row.travel, -1.0 / 3.0};
  return recording;
}

TEST(RecordingCsv, WritesCalibratedValuesToTheirOwnTable) {
  EXPECT_EQ(calibrated_to_csv(make_recording(2)), "");
  const Recording recording = calibrated_recording();
  EXPECT_EQ(
      lines_of(calibrated_to_csv(recording)),
      (std::vector<std::string>{"time,travel,\"thumb, left/taxel_7\",\"thumb, left/taxel_3\"",
                                "0,0,0,-0.3333333333333333", "0.3333333333333333,0.0001,0.0001,-0.3333333333333333"}));
  EXPECT_EQ(recording_to_csv(recording), recording_to_csv(make_recording(2)));
}

TEST(RecordingNpz, HasCalibratedValuesNextToTheReadings) {
  auto arrays = test::parse_npz(recording_to_npz(calibrated_recording()));
  EXPECT_EQ(arrays["thumb, left/calibrated"].shape, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(arrays["thumb, left/calibrated"].doubles(), (std::vector<double>{0, -1.0 / 3.0, 1e-4, -1.0 / 3.0}));
  EXPECT_EQ(arrays["thumb, left/calibrated_unit"].texts(), std::vector<std::string>{"V"});
  EXPECT_FALSE(arrays.contains("finger/calibrated"));
  auto raw = test::parse_npz(recording_to_npz(make_recording(2)));
  EXPECT_EQ(arrays.size(), raw.size() + 2);
  for (const auto& [name, array] : raw) EXPECT_EQ(arrays[name].data, array.data) << name;
}

TEST(RecordingNpz, WritesTextAsUcs4) {
  const test::NpyArray names = test::parse_npz(recording_to_npz(make_recording(1)))["taxel_names"];
  EXPECT_EQ(names.type, "<U3");
  const std::u32string expected = {U't', U'i', U'p', U'p', U'\u00e4', U'd'};
  EXPECT_EQ(names.data, std::string(reinterpret_cast<const char*>(expected.data()), 4 * expected.size()));
}

TEST(RecordingNpz, DistinguishesSeveralSensorsByTheirGeom) {
  auto arrays = test::parse_npz(recording_to_npz(make_recording(2)));
  EXPECT_TRUE(arrays.contains("finger/readings"));
  EXPECT_EQ(arrays["thumb, left/polygons"].integers(), (std::vector<std::int64_t>{18, 18}));
  EXPECT_FALSE(arrays.contains("readings"));
}

TEST(RecordingNpz, GivesTheSameBytesForTheSameValues) {
  EXPECT_EQ(recording_to_npz(make_recording(1)), recording_to_npz(make_recording(1)));
}

TEST(RecordingSummary, GivesPeaksStepsAndRespondingTaxels) {
  Recording recording;
  recording.sensors.push_back({"finger", {0, 1, 2}, {"a", "b", "c"}, "", "Pa", 0});
  const double values[4][3] = {{0, 0, 0}, {40, 4.9, 0}, {100, 0, 0}, {70, 5.1, 0}};
  for (int i = 0; i < 4; ++i) {
    const Pose turned{glm::angleAxis(glm::radians(2.0 * i), dvec3(1, 0, 0)), dvec3(0, 0.001 * i, 0)};
    recording.mocap.push_back({dquat(1, 0, 0, 0), dvec3(i, 0, 0)});
    RecordedRow row{
        i,
        0,
        0.1 * i,
        {{dvec3(3, 4, 0) * static_cast<double>(i), 0.5 * i, 1, {values[i][0], values[i][1], values[i][2]}, {}}},
        {}};
    row.sensors[0].X_WM = recording.mocap.back() * turned;
    recording.rows.push_back(row);
  }
  const RecordedSensorSummary summary = summarize(recording).at(0);
  EXPECT_EQ(summary.taxels[0].peak, 100);
  EXPECT_EQ(summary.taxels[0].peak_travel, 0.2);
  EXPECT_DOUBLE_EQ(summary.taxels[0].largest_step, 0.6);
  EXPECT_TRUE(summary.taxels[0].responds);
  EXPECT_TRUE(summary.taxels[1].responds);
  EXPECT_FALSE(summary.taxels[2].responds);
  EXPECT_EQ(summary.taxels[2].largest_step, 0);
  EXPECT_DOUBLE_EQ(summary.largest_force, 15);
  EXPECT_DOUBLE_EQ(summary.largest_area, 1.5);
  EXPECT_NEAR(summary.deflection, 0.003, 1e-15);
  EXPECT_NEAR(summary.deflection_deg, 6.0, 1e-12);
}

}  // namespace
}  // namespace taxel
