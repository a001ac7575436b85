// Writes MCAP files, version 0 (https://mcap.dev/spec): messages with times on channels, in compressed chunks with
// checksums, indices and a summary, so that readers find any channel and time without reading the whole file.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taxel {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

/// The kinds of records.
enum class McapOpcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

/// Keys and values, in the order in which they are written.
using McapMap = std::vector<std::pair<std::string, std::string>>;

/// Builds one record, field by field.
class McapRecord {
 public:
  explicit McapRecord(McapOpcode opcode) : bytes_(kHeadBytes, '\0') { bytes_[0] = static_cast<char>(opcode); }

  /// Appends a whole number with the size of its type.
  template <std::unsigned_integral Number>
  McapRecord& number(Number value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  /// Appends a text after its length in four bytes.
  McapRecord& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  McapRecord& map(const McapMap& map) {
    std::uint32_t size = 0;
    for (const auto& [key, value] : map)
      size += static_cast<std::uint32_t>(2 * sizeof size + key.size() + value.size());
    number(size);
    for (const auto& [key, value] : map) text(key).text(value);
    return *this;
  }
  /// Appends bytes after their length in eight bytes.
  McapRecord& long_bytes(std::string_view bytes) {
    number(std::uint64_t{bytes.size()});
    return raw(bytes);
  }
  McapRecord& raw(std::string_view bytes) {
    bytes_.append(bytes);
    return *this;
  }

  /// Returns the bytes of the fields so far, without kind and length.
  [[nodiscard]] std::string_view content() const { return std::string_view(bytes_).substr(kHeadBytes); }
  /// Returns the whole record. The object is empty afterwards.
  [[nodiscard]] std::string take() {
    const std::uint64_t length = content().size();
    std::memcpy(bytes_.data() + 1, &length, sizeof length);
    return std::move(bytes_);
  }

 private:
  static constexpr std::size_t kHeadBytes = 1 + sizeof(std::uint64_t);

  std::string bytes_;
};

/// The checksum of bytes that arrive piece by piece.
class Crc32 {
 public:
  void add(std::string_view bytes);
  /// Returns the checksum of all bytes so far; 0 without bytes.
  [[nodiscard]] std::uint32_t value() const { return ~rest_; }

 private:
  std::uint32_t rest_ = ~std::uint32_t{0};  // remainder of the division by the polynomial, inverted
};

/// Returns the checksum of `bytes`.
std::uint32_t crc32(std::string_view bytes);

/// A stream of messages of one type.
struct McapChannel {
  std::uint16_t schema = 0;  ///< result of McapWriter::add_schema()
  std::string topic;
  std::string encoding;  ///< encoding of the messages, such as "cdr"
  McapMap metadata;
};

/// Writes one file from its begin to its end. Equal calls give equal bytes. Schemas and channels are added before the
/// messages that use them. Texts are UTF-8. Times are in nanoseconds.
class McapWriter {
 public:
  /// Receives the bytes of the file, piece by piece.
  using Sink = std::function<void(std::string_view bytes)>;

  /// Writes the begin of a file. `profile` is "ros2" or empty, `library` names the writing program.
  McapWriter(std::string_view profile, std::string_view library, Sink sink);

  /// Adds the definition of a type of messages and returns its number. Throws Error if there are 65535 already.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view definition);
  /// Adds a channel and returns its number. Throws Error if there are 65536 already.
  std::uint16_t add_channel(const McapChannel& channel);
  /// Adds a message; the messages of a channel are numbered from 0. The times may be in any order. Throws Error if
  /// Zstandard fails.
  void add_message(std::uint16_t channel, std::uint64_t time, std::string_view bytes);
  /// Adds a whole file, with the time 0.
  void add_attachment(std::string_view name, std::string_view media_type, std::string_view bytes);
  void add_metadata(std::string_view name, const McapMap& metadata);
  /// Writes the indices and the end of the file. No other function may be called afterwards.
  void finish();

 private:
  /// Times of messages; both are 0 without messages.
  struct TimeRange {
    std::uint64_t first = 0, last = 0;
    std::uint64_t messages = 0;
    void add(std::uint64_t time);
  };
  /// Records that are compressed together.
  struct Chunk {
    std::string records;
    std::map<std::uint16_t, std::string> index;  ///< times and offsets of the messages, by channel
    TimeRange times;
  };
  /// Finished records of the summary, by kind.
  struct Summary {
    std::string schemas, channels, chunks, attachments, metadata;
  };
  struct Counts {
    std::vector<std::uint64_t> messages;  ///< by channel
    std::uint16_t schemas = 0;
    std::uint32_t chunks = 0, attachments = 0, metadata = 0;
    TimeRange times;
  };

  void put(std::string_view bytes);
  void end_chunk();
  [[nodiscard]] std::string statistics() const;
  void put_summary();

  Sink sink_;
  std::uint64_t offset_ = 0;  // number of bytes written
  Crc32 crc_;                 // of all bytes written
  Chunk chunk_;
  Summary summary_;
  Counts counts_;
};

}  // namespace taxel
