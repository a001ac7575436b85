// The archive of a recording is read back bit for bit, and a broken archive is refused with the name of its broken
// part.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <cmath>
#include <fstream>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/recording/recording_files.h"

namespace taxel {
namespace {
namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
  const fs::path folder = fs::path(TAXEL_BINARY_DIR) / "npz_reader";
  fs::create_directories(folder);
  return folder / name;
}

/// Returns a recording of two sensors: one plain, one calibrated that reads by force and with shear.
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
  r.mocap.assign(5, {dquat(1, 0, 0, 0), dvec3(0.1, 0, 1.0 / 3.0)});
  r.mocap[1] = {dquat(0, 1, 0, 0), dvec3(0.2, -0.0, 1)};
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

TEST(ReadRecording, ReturnsEveryBit) {
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

TEST(ReadRecording, NamesTheBrokenPart) {
  const fs::path file = scratch("broken.npz");
  const std::string name = file.string() + ": ";
  fs::remove(file);
  EXPECT_EQ(complaint_of(file), name + "no such file");
  write_file_atomically(file, "no archive");
  EXPECT_EQ(complaint_of(file), name + "cannot be read as .npz: Not a zip archive");
  Recording recording = full_recording();
  recording.rows.clear();
  write_file_atomically(file, recording_to_npz(recording));
  EXPECT_EQ(complaint_of(file), name + "time: has no rows");
  NpzWriter npz;
  npz.add("mocap_pos", {0, 3}, std::span<const double>());
  npz.add("mocap_quat", {0, 4}, std::span<const double>());
  const double step = 0.001;
  npz.add("timestep", {}, std::span(&step, 1));
  const std::vector<double> three{1, 2, 3};
  npz.add("time", {3}, three);
  write_file_atomically(file, npz.bytes());
  EXPECT_EQ(complaint_of(file), name + "travel: is missing");
  npz.add("travel", {1, 3}, three);
  write_file_atomically(file, npz.bytes());
  EXPECT_EQ(complaint_of(file), name + "travel: is of shape (1, 3), must be (3)");
  NpzWriter texts;
  texts.add("mocap_pos", "now");
  write_file_atomically(file, texts.bytes());
  EXPECT_EQ(complaint_of(file), name + "mocap_pos: is of type <U3, not <f8");
  // A shape larger than the data, in a member without an updated zip checksum, is refused with some message.
  std::string bytes = npz.bytes();
  bytes[bytes.find("(3,") + 1] = '9';
  write_file_atomically(file, bytes);
  EXPECT_EQ(complaint_of(file).rfind(name + "time: ", 0), 0U) << complaint_of(file);
}

// A changed byte gives an error, or it changes nothing that is read (dates and padding of the archive).
TEST(ReadRecording, RefusesOrIgnoresEveryWrongByte) {
  const std::string bytes = recording_to_npz(full_recording());
  const fs::path file = scratch("flipped.npz");
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 13) {
    std::string wrong = bytes;
    wrong[i] = static_cast<char>(wrong[i] ^ 0x5a);
    std::ofstream(file, std::ios::binary) << wrong;
    try {
      EXPECT_EQ(recording_to_npz(read_recording(file)), bytes) << "byte " << i << " was read as another value";
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

/// Returns the message of the reader for a recording with one change.
template <class Change>
std::string complaint_after(const Change& change) {
  Recording recording = full_recording();
  change(recording);
  const fs::path file = scratch("changed.npz");
  write_file_atomically(file, recording_to_npz(recording));
  const std::string message = complaint_of(file);
  return message.empty() ? message : message.substr(file.string().size() + 2);
}

TEST(ReadRecording, RefusesInvalidValues) {
  const double nan = std::nan("");
  EXPECT_EQ(complaint_after([&](Recording& r) { r.rows[1].time = nan; }), "time: value 1 must be finite, is nan");
  EXPECT_EQ(complaint_after([](Recording& r) { r.rows[2].time = 0; }),
            "time: row 2 must be later than 0.3333333333333333 s of the row before, is 0 s");
  EXPECT_EQ(complaint_after([](Recording& r) { r.rows[2].step = 5; }), "step: value 2 must be from 0 to 4, is 5");
  EXPECT_EQ(complaint_after([](Recording& r) { r.rows[0].step = -1; }), "step: value 0 must be from 0 to 4, is -1");
  EXPECT_EQ(complaint_after([](Recording& r) { r.rows[2].step = 2; }),
            "step: row 2 must be greater than 2 of the row before, is 2");
  EXPECT_EQ(complaint_after([&](Recording& r) { r.mocap[3].p.y = nan; }), "mocap_pos: value 10 must be finite, is nan");
  EXPECT_EQ(complaint_after([](Recording& r) { r.mocap[3].q = dquat(0, 0, 0, 0); }),
            "mocap_quat: quaternion 3 must be of length 1, is of length 0");
  EXPECT_EQ(complaint_after([](Recording& r) { r.timestep = 0; }), "timestep: must be greater than 0, is 0");
  EXPECT_EQ(complaint_after([&](Recording& r) { r.rows[0].sensors[0].readings[1] = nan; }),
            "finger/readings: value 1 must be finite, is nan");
  EXPECT_EQ(complaint_after([](Recording& r) { r.rows[1].objects[0].q *= 3.0; }),
            "object_quat: quaternion 2 must be of length 1, is of length 3");
}

TEST(ReadRecording, RefusesTaxelIdsThatDoNotFit) {
  const std::string bytes = recording_to_npz(full_recording());
  NpzWriter npz;
  const fs::path file = scratch("ids.npz");
  write_file_atomically(file, bytes);
  const NpzReader good(file);
  for (const char* name : {"mocap_pos", "mocap_quat", "object_pos", "object_quat", "time", "travel"})
    npz.add(name, good.shape(name), good.doubles(name, good.shape(name)));
  npz.add("timestep", {}, good.doubles("timestep", {}));
  npz.add("step", good.shape("step"), good.integers("step", good.shape("step")));
  npz.add("object_names", good.texts("object_names"));
  npz.add("sensor_geoms", std::vector<std::string>{"finger"});
  const std::vector<std::int64_t> ids{7, 3 + (std::int64_t{1} << 40)};
  npz.add("taxel_ids", {2}, ids);
  write_file_atomically(file, npz.bytes());
  EXPECT_EQ(complaint_of(file),
            file.string() + ": taxel_ids: value 1 must be from -2147483648 to 2147483647, is 1099511627779");
}

/// Returns the message of reading the texts of an array in NPY 1.0.
std::string complaint_of_texts(const std::string& dictionary, const std::string& data) {
  std::string npy("\x93NUMPY\x01\x00", 8);
  npy += static_cast<char>(dictionary.size());
  npy += '\0';
  NpzWriter npz;
  npz.add_file("names.npy", npy + dictionary + data);
  const NpzReader in(ZipArchive("a.npz", npz.bytes()));
  try {
    return fmt::format("accepted: {}", fmt::join(in.texts("names"), ","));
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(NpzReader, RefusesTextsThatHoldNoCharacters) {
  const std::string head = "{'descr': '<U1', 'fortran_order': False, 'shape': (2,), }";
  const auto texts = [&](const std::string& second) {
    return complaint_of_texts(head, std::string("P\0\0\0", 4) + second);
  };
  EXPECT_EQ(texts(std::string("\xe9\0\0\0", 4)), "accepted: P,\xc3\xa9");
  EXPECT_EQ(texts(std::string("P\0\0\n", 4)),
            "a.npz: names: text 1 must hold characters of Unicode, holds number 0xa000050");
  EXPECT_EQ(texts(std::string("\0\xd8\0\0", 4)),
            "a.npz: names: text 1 must hold characters of Unicode, holds number 0xd800");
}

TEST(NpzReader, RefusesAnOrderThatIsNotByRows) {
  for (const char* order : {"True", "1e30", ""})
    EXPECT_EQ(complaint_of_texts(fmt::format("{{'descr': '<U1', 'fortran_order': {}, 'shape': (1,), }}", order),
                                 std::string("P\0\0\0", 4)),
              "a.npz: names: lies in memory column by column, which is not read");
}

/// Returns a zip archive with one deflated member: `size` zeros under this name.
std::string zip_of_zeros(const std::string& name, std::size_t size) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* buffer = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(buffer);
  zip_t* archive = zip_open_from_source(buffer, ZIP_TRUNCATE, &error);
  const std::string zeros(size, '\0');
  zip_source_t* source = zip_source_buffer(archive, zeros.data(), zeros.size(), 0);
  const zip_int64_t member = zip_file_add(archive, name.c_str(), source, 0);
  zip_set_file_compression(archive, static_cast<zip_uint64_t>(member), ZIP_CM_DEFLATE, 1);
  EXPECT_EQ(zip_close(archive), 0);
  zip_stat_t status;
  zip_source_open(buffer);
  zip_source_stat(buffer, &status);
  std::string bytes(status.size, '\0');
  zip_source_read(buffer, bytes.data(), bytes.size());
  zip_source_close(buffer);
  zip_source_free(buffer);
  return bytes;
}

TEST(ZipArchive, BoundsTheUnpackedSize) {
  const fs::path file = scratch("bomb.npz");
  const std::size_t size = (ZipArchive::kFreeBytes + (std::size_t{1} << 25));
  write_file_atomically(file, zip_of_zeros("time.npy", size));
  ASSERT_LT(fs::file_size(file), size / 200);
  const ZipArchive archive(file);
  try {
    (void)archive.read("time.npy");
    ADD_FAILURE() << "was unpacked";
  } catch (const Error& e) {
    EXPECT_EQ(e.message().rfind(
                  fmt::format("announces {} bytes; of an archive of {} bytes at most", size, fs::file_size(file)), 0),
              0U)
        << e.message();
  }
}

TEST(ZipArchive, LeavesUnknownMembersPacked) {
  const fs::path file = scratch("unknown.npz");
  write_file_atomically(file, zip_of_zeros("unknown.npy", ZipArchive::kFreeBytes + (std::size_t{1} << 25)));
  EXPECT_EQ(complaint_of(file), file.string() + ": mocap_pos: is missing");
}

}  // namespace
}  // namespace taxel
