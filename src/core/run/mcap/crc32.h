// CRC-32 of bytes, as zlib, PNG and MCAP compute it (ISO 3309, polynomial 0xEDB88320 in reversed order).
#pragma once

#include <cstdint>
#include <string_view>

namespace taxel {

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

}  // namespace taxel
