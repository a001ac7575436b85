// The records of an MCAP file (https://mcap.dev/spec): a byte that names the kind, the length of the content, the
// content. All numbers are little endian.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
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

}  // namespace taxel
