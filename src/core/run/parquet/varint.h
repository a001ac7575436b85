// Numbers of seven bits in a byte, of which all but the last have the highest bit set. The number zero is one byte.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace taxel::parquet {

inline void put_varint(std::string& bytes, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) bytes += static_cast<char>(number | 0x80);
  bytes += static_cast<char>(number);
}

/// Writes a signed number: 0, -1, 1, -2 are written as 0, 1, 2, 3.
inline void put_signed_varint(std::string& bytes, std::int64_t number) {
  const auto bits = static_cast<std::uint64_t>(number);
  put_varint(bytes, number < 0 ? ~(bits << 1) : bits << 1);
}

/// Removes a number from the begin of `bytes`. Throws Error if the bytes end early or the number is too long.
inline std::uint64_t take_varint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (bytes.empty()) throw Error("is damaged: it ends within a number");
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= std::uint64_t{byte & 0x7fU} << shift;
    if (byte < 0x80) return number;
  }
  throw Error("is damaged: a number has too many bytes");
}

inline std::int64_t take_signed_varint(std::string_view& bytes) {
  const std::uint64_t bits = take_varint(bytes);
  return static_cast<std::int64_t>((bits & 1) != 0 ? ~(bits >> 1) : bits >> 1);
}

}  // namespace taxel::parquet
