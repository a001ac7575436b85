// MCAP files: messages and records byte by byte, and indices and checksums of whole files. tests/mcap reads exported
// recordings with the readers of PyPI.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include "core/run/mcap/mcap_writer.h"
#include "core/run/mcap/recording_mcap.h"
#include "core/run/mcap/ros_messages.h"
#include "core/run/parquet/encodings.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

/// Returns bytes written as a list of hexadecimal numbers.
std::string from_hex(const std::string& text) {
  std::istringstream in(text);
  std::string bytes;
  for (int byte = 0; in >> std::hex >> byte;) bytes += static_cast<char>(byte);
  return bytes;
}

/// Returns the checksum by the definition, bit by bit.
std::uint32_t slow_crc32(std::string_view bytes) {
  std::uint32_t rest = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    rest ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 1U) != 0 ? (rest >> 1U) ^ 0xEDB88320U : rest >> 1U;
  }
  return ~rest;
}

/// Reads the fields of a record one after the other.
struct FieldReader {
  std::string_view bytes;

  std::string_view take(std::size_t size) {
    const std::string_view taken = bytes.substr(0, size);
    EXPECT_EQ(taken.size(), size);
    bytes.remove_prefix(taken.size());
    return taken;
  }
  template <class Number>
  Number number() {
    Number value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
};

/// A record and its place in the file or chunk.
struct FoundRecord {
  std::uint64_t offset = 0, size = 0;
  McapOpcode opcode{};
  std::string_view content;
};

FoundRecord record_at(std::string_view bytes, std::uint64_t offset) {
  FieldReader reader{bytes.substr(offset)};
  FoundRecord record;
  record.offset = offset;
  record.opcode = static_cast<McapOpcode>(reader.number<std::uint8_t>());
  record.content = reader.take(reader.number<std::uint64_t>());
  record.size = bytes.size() - reader.bytes.size() - offset;
  return record;
}

std::vector<FoundRecord> records_in(std::string_view bytes, std::uint64_t first) {
  std::vector<FoundRecord> records;
  for (std::uint64_t at = first; at < bytes.size(); at += records.back().size) records.push_back(record_at(bytes, at));
  return records;
}

constexpr std::size_t kMagicBytes = 8;

/// Returns the records of a file between its two marks.
std::vector<FoundRecord> records_of(std::string_view file) {
  EXPECT_EQ(file.substr(0, kMagicBytes), from_hex("89 4d 43 41 50 30 0d 0a"));
  EXPECT_EQ(file.substr(file.size() - kMagicBytes), file.substr(0, kMagicBytes));
  return records_in(file.substr(0, file.size() - kMagicBytes), kMagicBytes);
}

std::vector<FoundRecord> records_of(std::string_view file, McapOpcode opcode) {
  std::vector<FoundRecord> records = records_of(file);
  std::erase_if(records, [&](const FoundRecord& record) { return record.opcode != opcode; });
  return records;
}

/// Returns a file with three messages of two kilobytes in each of `rows` rows, on two channels.
std::string long_file(std::uint64_t rows) {
  std::string bytes;
  McapWriter writer("ros2", "test", [&](std::string_view more) { bytes += more; });
  const std::uint16_t schema = writer.add_schema("a/msg/B", "ros2msg", "int32 x\n");
  const std::uint16_t one = writer.add_channel({schema, "/one", "cdr", {{"key", "value"}}});
  const std::uint16_t two = writer.add_channel({schema, "/two", "cdr", {}});
  writer.add_metadata("facts", {{"unit", "Pa"}, {"", ""}});
  writer.add_attachment("file.json", "application/json", "{}");
  for (std::uint64_t row = 0; row < rows; ++row) {
    const std::string message(2000, static_cast<char>(row));
    writer.add_message(one, 1000 + row, message);
    writer.add_message(two, 1000 + row, message + "x");
    writer.add_message(two, 1000 + row, message + "y");
  }
  writer.finish();
  return bytes;
}

TEST(Crc32, MatchesTheCheckValueAndTheDefinition) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32(""), 0U);
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i * i % 251);
  Crc32 in_pieces;
  in_pieces.add(std::string_view(bytes).substr(0, 333));
  in_pieces.add(std::string_view(bytes).substr(333));
  EXPECT_EQ(in_pieces.value(), slow_crc32(bytes));
}

TEST(CdrWriter, AlignsNumbersBehindTheHead) {
  CdrWriter writer;
  writer.add(std::string_view("ab"));
  writer.add(std::int32_t{-2});
  writer.add(1.0);
  writer.add_list(std::span<const double>());
  writer.add_list(std::span<const std::int32_t>(std::vector<std::int32_t>{7}));
  const std::vector<std::string> names{"x", ""};
  writer.add_list(names);
  writer.add_list(std::span<const double>(std::vector{-0.0}));
  EXPECT_EQ(writer.take(), from_hex("00 01 00 00 "              // little endian
                                    "03 00 00 00 61 62 00 00 "  // "ab", one byte of padding
                                    "fe ff ff ff 00 00 00 00 "  // -2, padding
                                    "00 00 00 00 00 00 f0 3f "  // 1.0
                                    "00 00 00 00 "              // a list without elements has no padding
                                    "01 00 00 00 07 00 00 00 "  // list of one number
                                    "02 00 00 00 "              // list of two texts
                                    "02 00 00 00 78 00 00 00 "  // "x"
                                    "01 00 00 00 00 00 00 00 "  // ""
                                    "01 00 00 00 00 00 00 00 "  // list of one number, which begins at a multiple of 8
                                    "00 00 00 00 00 00 00 80"));
}

TEST(RosMessages, HaveTheBytesOfTheirTypes) {
  const RosHeader header{ros_stamp(1.25), "w"};
  const std::string head = "00 01 00 00 01 00 00 00 80 b2 e6 0e 02 00 00 00 77 00 ";
  EXPECT_EQ(vector_message(header, dvec3(1, 2, -2)),
            from_hex(head + "00 00 00 00 00 00 00 00 f0 3f 00 00 00 00 00 00 00 40 00 00 00 00 00 00 00 c0"));
  const std::string pose = pose_message(header, {dquat(0.5, 1, 2, -2), dvec3(0, 1, 2)});
  EXPECT_EQ(pose.substr(pose.size() - 8), from_hex("00 00 00 00 00 00 e0 3f"));  // w is the last number
  EXPECT_EQ(pose.size(), 4U + 16U + 7U * 8U);
  const FramePose frames[] = {{"f", {}}, {"g", {}}};
  EXPECT_EQ(transforms_message(header, frames).substr(4, 24),
            from_hex("02 00 00 00 01 00 00 00 80 b2 e6 0e 02 00 00 00 77 00 00 00 02 00 00 00"));
  EXPECT_EQ(contact_message(header, {1, 2, -2, 258}).substr(44), from_hex("02 01 00 00"));
}

TEST(RosMessages, RefuseTimesThatNoStampHolds) {
  EXPECT_EQ(ros_stamp(2.0000000004).nanoseconds(), 2'000'000'000U);
  EXPECT_EQ(ros_stamp(0.9999999999).sec, 1);
  const std::string end = " s: use CSV or NPZ";
  for (const double time : {-0.5, 3e9, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(complaint_of([&] { ros_stamp(time); }),
              fmt::format("time: must be 0 to 2147483647 s in a message of ROS 2, is {}{}", time, end));
}

TEST(RosTypes, DefineTheTypeOfEachField) {
  for (const RosType type : {RosType::tactile_readings, RosType::tactile_contact, RosType::vector_stamped,
                             RosType::pose_stamped, RosType::transforms}) {
    const std::string definition = ros_type_definition(type);
    std::istringstream lines(definition);
    std::map<std::string, int> defined;
    std::vector<std::string> used;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("MSG: ")) ++defined[line.substr(5)];
      const std::string name = line.substr(0, std::min(line.find(' '), line.find('[')));
      if (!line.starts_with("#") && !line.starts_with("=") && name.find('/') != std::string::npos) used.push_back(name);
    }
    for (const std::string& name : used) EXPECT_EQ(defined[name], 1) << name << " in " << ros_type_name(type);
    EXPECT_GE(used.size(), defined.size()) << ros_type_name(type);
  }
  EXPECT_EQ(ros_type_name(RosType::transforms), "tf2_msgs/msg/TFMessage");
  EXPECT_TRUE(ros_type_definition(RosType::vector_stamped)
                  .starts_with("std_msgs/Header header\ngeometry_msgs/Vector3 vector\n" + std::string(80, '=') +
                               "\nMSG: geometry_msgs/Vector3\nfloat64 x\n"));
}

TEST(RosNames, AreValidAndDiffer) {
  RosNames names;
  EXPECT_EQ(names.add("thumb/tip, left"), "thumb_tip_left");
  EXPECT_EQ(names.add("thumb tip left"), "thumb_tip_left_2");
  EXPECT_EQ(names.add("3"), "geom_3");
  EXPECT_EQ(names.add("__\xc3\xa4__"), "geom");
  EXPECT_EQ(names.add(""), "geom_2");
  EXPECT_EQ(utf8_or_marks("\xc3\xa4"), "\xc3\xa4");
  EXPECT_EQ(utf8_or_marks("a\xe4"), "a?");
}

TEST(McapWriter, WritesTheRecordsOfAFileWithoutMessages) {
  std::string bytes;
  McapWriter writer("ros2", "me", [&](std::string_view more) { bytes += more; });
  writer.finish();
  const std::string begin = from_hex(
      "89 4d 43 41 50 30 0d 0a "
      "01 0e 00 00 00 00 00 00 00 04 00 00 00 72 6f 73 32 02 00 00 00 6d 65 ");
  ASSERT_EQ(bytes.substr(0, begin.size()), begin);
  EXPECT_EQ(bytes.substr(begin.size(), 9), from_hex("0f 04 00 00 00 00 00 00 00"));
  const std::vector<FoundRecord> records = records_of(bytes);
  ASSERT_EQ(records.size(), 5U);  // header, end of the data, statistics, their offset, footer
  EXPECT_EQ(FieldReader{records[1].content}.number<std::uint32_t>(), slow_crc32(begin));
  EXPECT_EQ(records[2].content, std::string(46, '\0'));
}

/// Checks the messages of one channel in a chunk against their index, and returns their number.
std::uint64_t check_entries(std::string_view chunk, std::uint16_t channel, std::string_view entries) {
  std::uint64_t count = 0;
  for (FieldReader pairs{entries}; !pairs.bytes.empty(); ++count) {
    const auto time = pairs.number<std::uint64_t>();
    const FoundRecord message = record_at(chunk, pairs.number<std::uint64_t>());
    EXPECT_EQ(message.opcode, McapOpcode::message);
    FieldReader fields{message.content};
    EXPECT_EQ(fields.number<std::uint16_t>(), channel);
    const auto sequence = fields.number<std::uint32_t>();
    EXPECT_EQ(channel == 0 ? sequence : sequence / 2, time - 1000);
    EXPECT_EQ(fields.number<std::uint64_t>(), time);
    EXPECT_EQ(fields.number<std::uint64_t>(), time);
    EXPECT_EQ(fields.bytes.front(), static_cast<char>(time - 1000));
  }
  return count;
}

/// Checks a chunk and its messages against their indices, and returns the number of messages.
std::uint64_t check_chunk(std::string_view file, const FoundRecord& found) {
  FieldReader index{found.content};
  const auto first = index.number<std::uint64_t>(), last = index.number<std::uint64_t>();
  const auto begin = index.number<std::uint64_t>(), size = index.number<std::uint64_t>();
  FieldReader offsets{index.text()};
  const auto size_of_entries = index.number<std::uint64_t>();
  const FoundRecord record = record_at(file, begin);
  EXPECT_EQ(record.opcode, McapOpcode::chunk);
  EXPECT_EQ(record.size, size);
  FieldReader chunk{record.content};
  EXPECT_EQ(chunk.number<std::uint64_t>(), first);
  EXPECT_EQ(chunk.number<std::uint64_t>(), last);
  const auto full_size = chunk.number<std::uint64_t>();
  const auto crc = chunk.number<std::uint32_t>();
  EXPECT_EQ(chunk.text(), "zstd");
  const std::string content = zstd_uncompressed(chunk.take(chunk.number<std::uint64_t>()), full_size);
  EXPECT_EQ(crc, slow_crc32(content));
  std::uint64_t end = begin + size, messages = 0;
  while (!offsets.bytes.empty()) {
    const auto channel = offsets.number<std::uint16_t>();
    EXPECT_EQ(offsets.number<std::uint64_t>(), end);
    const FoundRecord entries = record_at(file, end);
    EXPECT_EQ(entries.opcode, McapOpcode::message_index);
    end += entries.size;
    FieldReader fields{entries.content};
    EXPECT_EQ(fields.number<std::uint16_t>(), channel);
    messages += check_entries(content, channel, fields.text());
  }
  EXPECT_EQ(end - begin - size, size_of_entries);
  return messages;
}

TEST(McapWriter, IndexesEachMessageOfEachChunk) {
  const std::uint64_t rows = 600;
  const std::string file = long_file(rows);
  const std::vector<FoundRecord> indices = records_of(file, McapOpcode::chunk_index);
  EXPECT_GE(indices.size(), 3U);
  EXPECT_EQ(indices.size(), records_of(file, McapOpcode::chunk).size());
  std::uint64_t messages = 0;
  for (const FoundRecord& index : indices) messages += check_chunk(file, index);
  EXPECT_EQ(messages, 3 * rows);
  FieldReader statistics{records_of(file, McapOpcode::statistics).at(0).content};
  EXPECT_EQ(statistics.number<std::uint64_t>(), 3 * rows);
  EXPECT_EQ(statistics.number<std::uint16_t>(), 1U);  // types
  for (const std::uint32_t count : {2U, 1U, 1U, static_cast<std::uint32_t>(indices.size())})
    EXPECT_EQ(statistics.number<std::uint32_t>(), count);  // channels, attachments, metadata, chunks
  EXPECT_EQ(statistics.number<std::uint64_t>(), 1000U);
  EXPECT_EQ(statistics.number<std::uint64_t>(), 1000 + rows - 1);
}

TEST(McapWriter, ChecksumsDataAttachmentsAndSummary) {
  const std::string file = long_file(3);
  const FoundRecord end = records_of(file, McapOpcode::data_end).at(0);
  EXPECT_EQ(FieldReader{end.content}.number<std::uint32_t>(), slow_crc32(std::string_view(file).substr(0, end.offset)));
  const FoundRecord attachment = records_of(file, McapOpcode::attachment).at(0);
  const std::size_t size = attachment.content.size() - 4;
  EXPECT_EQ(FieldReader{attachment.content.substr(size)}.number<std::uint32_t>(),
            slow_crc32(attachment.content.substr(0, size)));
  const FoundRecord footer = records_of(file).back();
  FieldReader fields{footer.content};
  const auto summary = fields.number<std::uint64_t>(), offsets = fields.number<std::uint64_t>();
  EXPECT_EQ(summary, end.offset + end.size);
  EXPECT_EQ(record_at(file, offsets).opcode, McapOpcode::summary_offset);
  const std::uint64_t crc_at = footer.offset + footer.size - 4;
  EXPECT_EQ(fields.number<std::uint32_t>(), slow_crc32(std::string_view(file).substr(summary, crc_at - summary)));
}

TEST(McapWriter, FindsTheGroupsOfTheSummary) {
  const std::string file = long_file(3);
  std::uint64_t end = 0;
  for (const FoundRecord& offset : records_of(file, McapOpcode::summary_offset)) {
    FieldReader fields{offset.content};
    const auto opcode = static_cast<McapOpcode>(fields.number<std::uint8_t>());
    const auto begin = fields.number<std::uint64_t>(), size = fields.number<std::uint64_t>();
    EXPECT_TRUE(end == 0 || begin == end);
    end = begin + size;
    for (const FoundRecord& record : records_in(std::string_view(file).substr(0, end), begin))
      EXPECT_EQ(record.opcode, opcode);
  }
  EXPECT_EQ(end, records_of(file, McapOpcode::summary_offset).at(0).offset);
  for (const auto& [opcode, target] : {std::pair{McapOpcode::attachment_index, McapOpcode::attachment},
                                       std::pair{McapOpcode::metadata_index, McapOpcode::metadata}}) {
    FieldReader index{records_of(file, opcode).at(0).content};
    const FoundRecord record = records_of(file, target).at(0);
    EXPECT_EQ(index.number<std::uint64_t>(), record.offset);
    EXPECT_EQ(index.number<std::uint64_t>(), record.size);
  }
}

TEST(RecordingMcap, HasEqualBytesForEqualRecordings) {
  Recording recording;
  recording.sensors = {{"a", {7, 3}, {"tip", ""}, "{}", "Pa", 1}, {"plate", {}, {}, "{}", "Pa", 1}};
  recording.rows.push_back({0, 0.5, 0, {SensorRecord{}, SensorRecord{}}, {}});
  recording.rows[0].sensors[0].readings = {1, 2};
  recording.mocap = {Pose{}};
  const std::string bytes = recording_to_mcap(recording, {"taxel", "run.json", "{}"});
  EXPECT_EQ(bytes, recording_to_mcap(recording, {"taxel", "run.json", "{}"}));
  EXPECT_EQ(records_of(bytes, McapOpcode::attachment).size(), 3U);
  EXPECT_EQ(records_of(bytes, McapOpcode::channel).size(), 4U + 3U + 1U);  // no readings without taxels
  recording.rows.clear();
  EXPECT_EQ(records_of(recording_to_mcap(recording, {}), McapOpcode::chunk_index).size(), 1U);
}

/// Returns the messages of a file's first chunk.
std::string first_chunk(const std::string& file) {
  FieldReader chunk{records_of(file, McapOpcode::chunk).at(0).content};
  for (int i = 0; i < 2; ++i) (void)chunk.number<std::uint64_t>();  // times
  const auto full_size = chunk.number<std::uint64_t>();
  (void)chunk.number<std::uint32_t>();  // checksum
  (void)chunk.text();                   // compression
  return zstd_uncompressed(chunk.take(chunk.number<std::uint64_t>()), full_size);
}

TEST(RecordingMcap, HasAFrameOfAMocapBodyThatOnlyTurns) {
  Recording recording;
  recording.rows.push_back({0, 0.5, 0, {}, {}});
  recording.mocap = {Pose{}, Pose{}};
  const std::string frame("\6\0\0\0mocap\0", 10);
  EXPECT_EQ(first_chunk(recording_to_mcap(recording, {})).find(frame), std::string::npos) << "one that rests has none";
  recording.mocap[1].q = {std::cos(0.1), 0, 0, std::sin(0.1)};
  EXPECT_NE(first_chunk(recording_to_mcap(recording, {})).find(frame), std::string::npos);
}

TEST(RecordingMcap, HasSlipAsSharesIfFrictionSticks) {
  Recording recording;
  recording.sensors = {{"a", {7, 3}, {"tip", ""}, "{}", "Pa", 1}};
  recording.rows.push_back({0, 0.5, 0, {SensorRecord{}}, {}});
  recording.rows[0].sensors[0].readings = {1, 2};
  recording.rows[0].sensors[0].slip = {0.25, 1};
  const std::string without = recording_to_mcap(recording, {});
  EXPECT_EQ(without.find("/taxel/a/slip"), std::string::npos);
  recording.sensors[0].slip = true;
  const std::string bytes = recording_to_mcap(recording, {});
  EXPECT_EQ(records_of(bytes, McapOpcode::channel).size(), records_of(without, McapOpcode::channel).size() + 1);
  EXPECT_NE(bytes.find("/taxel/a/slip"), std::string::npos);
  std::string slip = bytes.substr(bytes.find("/taxel/a/slip"));
  EXPECT_NE(slip.find(std::string("values.unit\x01\0\0\0"
                                  "1",
                                  16)),
            std::string::npos)
      << "a share has the unit 1";
}

TEST(RecordingMcap, NamesTheFileThatItDoesNotWrite) {
  const TempFolder folder;
  Recording recording;
  recording.rows.push_back({0, -1, 0, {}, {}});
  EXPECT_TRUE(complaint_of([&] {
                write_mcap(folder / "a.mcap", recording, {});
              }).starts_with((folder / "a.mcap").string() + ": time: must be 0 to 2147483647 s"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  recording.rows[0].time = 1;
  EXPECT_TRUE(complaint_of([&] {
                write_mcap(folder / "absent/a.mcap", recording, {});
              }).starts_with((folder / "absent/a.mcap").string() + ": "));
  write_mcap(folder / "a.mcap", recording, {});
  EXPECT_TRUE(std::filesystem::exists(folder / "a.mcap"));
}

}  // namespace
}  // namespace taxel::test
