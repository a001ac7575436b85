// What a recording's archive holds comes back bit for bit; an archive that is broken is refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/project/recording/npz.h"

namespace taxel {
namespace {
namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
  const fs::path folder = fs::path(TAXEL_BINARY_DIR) / "npz_reader";
  fs::create_directories(folder);
  return folder / name;
}

/// Two sensors: one plain, one calibrated, by force and with shear.
Recording full_recording() {
  Recording r;
  r.timestep = 0.002;
  r.objects = {"box",
               "p\xc3\xa4"
               "d"};
  for (int s = 0; s < 2; ++s)
    r.sensors.push_back({s == 0 ? "finger" : "thumb", {7, 3}, {"tip", ""}, "{\"x\": 1}", "Pa", 1ULL << 63});
  r.sensors[1].calibrated_unit.emplace("V");
  r.sensors[1].reading_unit = "N";
  r.sensors[1].force = r.sensors[1].shear = true;
  r.sensors[1].tangents = {{dvec3(1, 0, 0), dvec3(0, 1, 0)}, {dvec3(0, 0, 1), dvec3(1, 0, 0)}};
  r.mocap = {{dquat(1, 0, 0, 0), dvec3(0.1, 0, 1.0 / 3.0)}, {dquat(0, 1, 0, 0), dvec3(0.2, -0.0, 1)}};
  for (int i = 0; i < 3; ++i) {
    RecordedRow row{2 * i, i / 3.0, 1e-4 * i, {}, {Pose{dquat(0, 1, 0, 0), dvec3(i, 2, 3)}, Pose{}}};
    for (int s = 0; s < 2; ++s)
      row.sensors.push_back({dvec3(0.1 + 0.2, -1e-300, i),
                             std::nextafter(1.0, 2.0),
                             17 + s,
                             {1e22 * i, std::sqrt(2.0)},
                             Pose{dquat(0.6, 0.8, 0, 0), dvec3(s, i, 0.1)}});
    row.sensors[1].calibrated = {0.5 * i, -1.0 / 3.0};
    row.sensors[1].shear = {dvec2(i, 1), dvec2(0, -2)};
    row.sensors[1].uncovered_W = dvec3(0, i, 0.5);
    r.rows.push_back(row);
  }
  return r;
}

TEST(ReadRecording, GivesBackEveryBit) {
  Recording recording = full_recording();
  for (const std::size_t sensors : {2U, 1U}) {
    recording.sensors.resize(sensors);
    for (RecordedRow& row : recording.rows) row.sensors.resize(sensors);
    const std::string bytes = recording_to_npz(recording);
    const fs::path file = scratch("readings.npz");
    write_file_atomically(file, bytes);
    EXPECT_EQ(recording_to_npz(read_recording(file)), bytes) << sensors;
    EXPECT_EQ(recording_to_npz(read_recording(file.parent_path())), bytes) << "by its folder";
  }
}

std::string complaint_of(const fs::path& file) {
  try {
    read_recording(file);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(ReadRecording, NamesWhatIsBroken) {
  const fs::path file = scratch("broken.npz");
  const std::string name = file.string() + ": ";
  fs::remove(file);
  EXPECT_EQ(complaint_of(file), name + "cannot be read as .npz: No such file");
  write_file_atomically(file, "no archive");
  EXPECT_EQ(complaint_of(file), name + "cannot be read as .npz: Not a zip archive");
  NpzWriter npz;
  const std::vector<double> three{1, 2, 3};
  npz.add("time", {3}, three);
  write_file_atomically(file, npz.bytes());
  EXPECT_EQ(complaint_of(file), name + "travel: is missing");
  npz.add("travel", {1, 3}, three);
  write_file_atomically(file, npz.bytes());
  EXPECT_EQ(complaint_of(file), name + "travel: is of shape (1, 3), must be (3)");
  NpzWriter texts;
  texts.add("time", "now");
  write_file_atomically(file, texts.bytes());
  EXPECT_EQ(complaint_of(file), name + "time: is of type <U3, not <f8");
  // A shape that says more than there is, in a member whose checksum zip has not kept up with, is refused somehow.
  std::string bytes = npz.bytes();
  bytes[bytes.find("(3,") + 1] = '9';
  write_file_atomically(file, bytes);
  EXPECT_EQ(complaint_of(file).rfind(name + "time: ", 0), 0U) << complaint_of(file);
}

// Any byte may be wrong: what comes is an error or a recording, never a crash.
TEST(ReadRecording, SurvivesEveryWrongByte) {
  const std::string bytes = recording_to_npz(full_recording());
  const fs::path file = scratch("flipped.npz");
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 41) {
    std::string wrong = bytes;
    wrong[i] = static_cast<char>(wrong[i] ^ 0x5a);
    std::ofstream(file, std::ios::binary) << wrong;
    refused += complaint_of(file).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace taxel
