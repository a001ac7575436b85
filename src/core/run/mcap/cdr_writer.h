// Writes values in the Common Data Representation of ROS 2 messages: CDR, little endian, of OMG's DDS-RTPS 2.3.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace taxel {

template <class Number>
concept CdrNumber =
    std::same_as<Number, std::int32_t> || std::same_as<Number, std::uint32_t> || std::same_as<Number, double>;

/// Appends the fields of one message in their order. Each number begins at a multiple of its size behind the head of
/// four bytes, which says that the message is plain and little endian.
class CdrWriter {
 public:
  CdrWriter() : bytes_("\0\1\0\0", kHeadBytes) {}  // plain CDR, little endian, no options
  void add(CdrNumber auto value) {
    align(sizeof value);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// Appends a text with its length and a closing zero.
  void add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text);
    bytes_ += '\0';
  }
  /// Appends a list of any length: the number of elements, then the elements.
  template <CdrNumber Number>
  void add_list(std::span<const Number> values) {
    add(static_cast<std::uint32_t>(values.size()));
    if (values.empty()) return;
    align(sizeof(Number));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void add_list(std::span<const std::string> texts) {
    add(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) add(std::string_view(text));
  }

  /// Returns the message. The object is empty afterwards.
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kHeadBytes = 4;

  void align(std::size_t size) {
    while ((bytes_.size() - kHeadBytes) % size != 0) bytes_ += '\0';
  }

  std::string bytes_;
};

}  // namespace taxel
