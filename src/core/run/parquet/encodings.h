// The encodings of Parquet pages: bytes of values, and small whole numbers in runs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/run/parquet/parquet.h"

namespace taxel::parquet {

// Numbers of seven bits in a byte, of which all but the last have the highest bit set. The number zero is one byte.

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

namespace taxel {

/// Returns the plain bytes of values: little endian; a text begins with its length in four bytes.
std::string plain_bytes(const ParquetValues& values);
/// Reads `count` plain values. Throws Error if there are fewer bytes.
ParquetValues from_plain(ParquetType type, std::size_t count, std::string_view bytes);

/// Returns the plain bytes of numbers of `width` bytes with all first bytes first, then all second bytes, and so on.
std::string split_streams(std::string_view plain, std::size_t width);
/// The inverse of split_streams(). Throws Error if the size is not a multiple of `width`.
std::string joined_streams(std::string_view split, std::size_t width);

/// Returns the number of bits of the largest of `count` numbers from 0; at least 1.
int bits_for(std::uint32_t count);

/// Returns numbers below 2^bits as runs of equal numbers and groups of eight packed numbers (RLE/bit-packing hybrid).
std::string packed_runs(std::span<const std::uint32_t> numbers, int bits);
/// Reads `count` numbers of packed_runs(). Throws Error if there are fewer, or if `bits` is not 0 to 32.
std::vector<std::uint32_t> from_packed_runs(std::string_view bytes, int bits, std::size_t count);

/// Values without repetition, and the index of each value.
struct ParquetDictionary {
  ParquetValues values;
  std::vector<std::uint32_t> indices;
};
/// Returns the dictionary in the order of the first use. Returns one without indices if there are more than `most`
/// different values. Numbers are equal if all their bits are.
ParquetDictionary dictionary_of(const ParquetValues& values, std::size_t most);
/// Returns the values of indices. Throws Error for an index that the dictionary does not have.
ParquetValues from_dictionary(const ParquetValues& dictionary, std::span<const std::uint32_t> indices);

/// Returns bytes compressed with Zstandard, with a checksum. Throws Error if Zstandard fails.
std::string zstd_compressed(std::string_view bytes);
/// Returns `size` uncompressed bytes. Throws Error if the bytes are damaged or have another size.
std::string zstd_uncompressed(std::string_view bytes, std::size_t size);

// The encoding DELTA_BINARY_PACKED of whole numbers: the differences of successive numbers, in blocks. The indices of
// rows, which count up, take hardly any bytes.

/// Returns the bytes of numbers. Differences wrap around at 64 bits.
std::string delta_bytes(std::span<const std::int64_t> numbers);

/// Reads `count` numbers of delta_bytes(). Throws Error if the bytes are damaged or have another count.
std::vector<std::int64_t> from_delta(std::string_view bytes, std::size_t count);

}  // namespace taxel
