#include "core/run/mcap/mcap_writer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/run/parquet/encodings.h"

namespace taxel {

namespace {

/// Returns the remainders of all bytes, so that a step of the division handles eight bits.
constexpr std::array<std::uint32_t, 256> make_crc_table() {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 1U) != 0 ? (rest >> 1U) ^ kPolynomial : rest >> 1U;
    table[byte] = rest;
  }
  return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

}  // namespace

void Crc32::add(std::string_view bytes) {
  std::uint32_t rest = rest_;
  for (const char byte : bytes) rest = kCrcTable[(rest ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (rest >> 8U);
  rest_ = rest;
}

std::uint32_t crc32(std::string_view bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

namespace {

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";  // first and last bytes of a file
constexpr std::string_view kMcapCompression = "zstd";
/// Size at which a chunk ends, before compression [bytes]. A reader unpacks a whole chunk to find one message, and
/// small chunks compress less.
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
constexpr std::size_t kMaxSchemas = std::numeric_limits<std::uint16_t>::max();  // 0 is no schema
constexpr std::size_t kMaxChannels = kMaxSchemas + 1;

}  // namespace

void McapWriter::TimeRange::add(std::uint64_t time) {
  first = messages == 0 ? time : std::min(first, time);
  last = std::max(last, time);
  ++messages;
}

McapWriter::McapWriter(std::string_view profile, std::string_view library, Sink sink) : sink_(std::move(sink)) {
  put(kMcapMagic);
  put(McapRecord(McapOpcode::header).text(profile).text(library).take());
}

void McapWriter::put(std::string_view bytes) {
  crc_.add(bytes);
  offset_ += bytes.size();
  sink_(bytes);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding, std::string_view definition) {
  if (counts_.schemas == kMaxSchemas) throw Error("an MCAP file has at most 65535 types of messages");
  const std::uint16_t id = ++counts_.schemas;
  const std::string record =
      McapRecord(McapOpcode::schema).number(id).text(name).text(encoding).text(definition).take();
  chunk_.records += record;
  summary_.schemas += record;
  return id;
}

std::uint16_t McapWriter::add_channel(const McapChannel& channel) {
  if (counts_.messages.size() == kMaxChannels) throw Error("an MCAP file has at most 65536 channels");
  const auto id = static_cast<std::uint16_t>(counts_.messages.size());
  counts_.messages.push_back(0);
  const std::string record = McapRecord(McapOpcode::channel)
                                 .number(id)
                                 .number(channel.schema)
                                 .text(channel.topic)
                                 .text(channel.encoding)
                                 .map(channel.metadata)
                                 .take();
  chunk_.records += record;
  summary_.channels += record;
  return id;
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t time, std::string_view bytes) {
  std::uint64_t& count = counts_.messages.at(channel);
  const std::uint64_t entry[] = {time, chunk_.records.size()};
  chunk_.index[channel].append(reinterpret_cast<const char*>(entry), sizeof entry);
  chunk_.records += McapRecord(McapOpcode::message)
                        .number(channel)
                        .number(static_cast<std::uint32_t>(count))
                        .number(time)
                        .number(time)
                        .raw(bytes)
                        .take();
  ++count;
  chunk_.times.add(time);
  counts_.times.add(time);
  if (chunk_.records.size() >= kChunkBytes) end_chunk();
}

void McapWriter::add_attachment(std::string_view name, std::string_view media_type, std::string_view bytes) {
  constexpr std::uint64_t kNoTime = 0;
  McapRecord record(McapOpcode::attachment);
  record.number(kNoTime).number(kNoTime).text(name).text(media_type).long_bytes(bytes);
  const std::uint32_t crc = crc32(record.content());
  const std::string whole = record.number(crc).take();
  summary_.attachments += McapRecord(McapOpcode::attachment_index)
                              .number(offset_)
                              .number(std::uint64_t{whole.size()})
                              .number(kNoTime)
                              .number(kNoTime)
                              .number(std::uint64_t{bytes.size()})
                              .text(name)
                              .text(media_type)
                              .take();
  put(whole);
  ++counts_.attachments;
}

void McapWriter::add_metadata(std::string_view name, const McapMap& metadata) {
  const std::string record = McapRecord(McapOpcode::metadata).text(name).map(metadata).take();
  summary_.metadata +=
      McapRecord(McapOpcode::metadata_index).number(offset_).number(std::uint64_t{record.size()}).text(name).take();
  put(record);
  ++counts_.metadata;
}

/// Writes the records since the last chunk, and behind them the index of each channel.
void McapWriter::end_chunk() {
  if (chunk_.records.empty()) return;
  const Chunk chunk = std::exchange(chunk_, {});
  const std::string compressed = zstd_compressed(chunk.records);
  const std::string record = McapRecord(McapOpcode::chunk)
                                 .number(chunk.times.first)
                                 .number(chunk.times.last)
                                 .number(std::uint64_t{chunk.records.size()})
                                 .number(crc32(chunk.records))
                                 .text(kMcapCompression)
                                 .long_bytes(compressed)
                                 .take();
  McapRecord index(McapOpcode::chunk_index);
  index.number(chunk.times.first).number(chunk.times.last).number(offset_).number(std::uint64_t{record.size()});
  index.number(static_cast<std::uint32_t>(chunk.index.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  put(record);
  const std::uint64_t begin = offset_;
  for (const auto& [channel, entries] : chunk.index) {
    index.number(channel).number(offset_);
    put(McapRecord(McapOpcode::message_index).number(channel).text(entries).take());
  }
  index.number(offset_ - begin).text(kMcapCompression);
  index.number(std::uint64_t{compressed.size()}).number(std::uint64_t{chunk.records.size()});
  summary_.chunks += index.take();
  ++counts_.chunks;
}

std::string McapWriter::statistics() const {
  const std::vector<std::uint64_t>& messages = counts_.messages;
  McapRecord record(McapOpcode::statistics);
  record.number(counts_.times.messages)
      .number(counts_.schemas)
      .number(static_cast<std::uint32_t>(messages.size()))
      .number(counts_.attachments)
      .number(counts_.metadata)
      .number(counts_.chunks)
      .number(counts_.times.first)
      .number(counts_.times.last)
      .number(static_cast<std::uint32_t>(messages.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  for (std::size_t i = 0; i < messages.size(); ++i) record.number(static_cast<std::uint16_t>(i)).number(messages[i]);
  return record.take();
}

/// Writes the summary, the offsets of its groups, and the footer, whose checksum covers all three.
void McapWriter::put_summary() {
  const std::uint64_t begin = offset_;
  crc_ = {};
  std::string offsets;
  const auto put_group = [&](McapOpcode opcode, const std::string& records) {
    if (records.empty()) return;
    offsets += McapRecord(McapOpcode::summary_offset)
                   .number(static_cast<std::uint8_t>(opcode))
                   .number(offset_)
                   .number(std::uint64_t{records.size()})
                   .take();
    put(records);
  };
  put_group(McapOpcode::schema, summary_.schemas);
  put_group(McapOpcode::channel, summary_.channels);
  put_group(McapOpcode::statistics, statistics());
  put_group(McapOpcode::chunk_index, summary_.chunks);
  put_group(McapOpcode::attachment_index, summary_.attachments);
  put_group(McapOpcode::metadata_index, summary_.metadata);
  const std::uint64_t offsets_begin = offset_;
  put(offsets);
  const std::string footer =
      McapRecord(McapOpcode::footer).number(begin).number(offsets_begin).number(std::uint32_t{0}).take();
  put(std::string_view(footer).substr(0, footer.size() - sizeof(std::uint32_t)));
  const std::uint32_t crc = crc_.value();
  put({reinterpret_cast<const char*>(&crc), sizeof crc});
}

void McapWriter::finish() {
  end_chunk();
  put(McapRecord(McapOpcode::data_end).number(crc_.value()).take());
  put_summary();
  put(kMcapMagic);
}

}  // namespace taxel
