#include "core/run/parquet/delta.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/error.h"
#include "core/run/parquet/varint.h"

namespace taxel {
namespace {

namespace pq = parquet;

constexpr std::size_t kBlock = 128, kParts = 4;  // numbers of a block, and its parts with bit widths of their own
constexpr std::size_t kPart = kBlock / kParts;
constexpr std::uint64_t kMostPart = 1U << 16;  // of a file that is read

/// Packs numbers, the first one in the lowest bits.
void put_packed(std::string& bytes, std::span<const std::uint64_t> numbers, int bits) {
  std::uint64_t buffer = 0;
  int filled = 0;
  const auto put = [&](std::uint64_t number, int count) {  // at most 32 bits
    buffer |= number << filled;
    for (filled += count; filled >= 8; filled -= 8, buffer >>= 8) bytes += static_cast<char>(buffer);
  };
  for (const std::uint64_t number : numbers) {
    put(number & 0xffffffffU, std::min(bits, 32));
    if (bits > 32) put(number >> 32, bits - 32);
  }
}

/// Reads the numbers of a part.
class PackedReader {
 public:
  PackedReader(std::string_view bytes, int bits) : bytes_(bytes), bits_(bits) {}
  std::uint64_t next() {
    const std::uint64_t low = take(std::min(bits_, 32));
    return bits_ > 32 ? low | take(bits_ - 32) << 32 : low;
  }

 private:
  std::uint64_t take(int count) {  // at most 32 bits
    for (; filled_ < count; filled_ += 8, bytes_.remove_prefix(1))
      buffer_ |= std::uint64_t{static_cast<unsigned char>(bytes_.front())} << filled_;
    const std::uint64_t number = buffer_ & ((std::uint64_t{1} << count) - 1);
    buffer_ >>= count;
    filled_ -= count;
    return number;
  }
  std::string_view bytes_;
  int bits_;
  std::uint64_t buffer_ = 0;
  int filled_ = 0;
};

/// Writes the differences of a block: the least one, the bit widths, and the numbers above the least one.
void put_block(std::string& bytes, std::span<const std::int64_t> differences) {
  const std::int64_t least = *std::ranges::min_element(differences);
  std::array<std::uint64_t, kBlock> above{};
  for (std::size_t i = 0; i < differences.size(); ++i)
    above[i] = static_cast<std::uint64_t>(differences[i]) - static_cast<std::uint64_t>(least);
  std::array<int, kParts> widths{};
  for (std::size_t i = 0; i < differences.size(); ++i)
    widths[i / kPart] = std::max(widths[i / kPart], static_cast<int>(std::bit_width(above[i])));
  pq::put_signed_varint(bytes, least);
  for (const int width : widths) bytes += static_cast<char>(width);
  for (std::size_t p = 0; p * kPart < differences.size(); ++p)
    put_packed(bytes, std::span(above).subspan(p * kPart, kPart), widths[p]);
}

/// The sizes at the begin of the bytes.
struct DeltaHead {
  std::uint64_t block = 0, parts = 0, count = 0;
};

DeltaHead take_head(std::string_view& bytes, std::size_t count) {
  DeltaHead head{pq::take_varint(bytes), pq::take_varint(bytes), pq::take_varint(bytes)};
  const bool is_valid = head.parts > 0 && head.block % head.parts == 0 && head.block / head.parts % 32 == 0 &&
                        head.block > 0 && head.block / head.parts <= kMostPart && head.parts <= kMostPart;
  if (!is_valid) throw Error(fmt::format("is damaged: blocks of {} numbers in {} parts", head.block, head.parts));
  if (head.count != count)
    throw Error(fmt::format("is damaged: has {} numbers where {} are announced", head.count, count));
  return head;
}

}  // namespace

std::string delta_bytes(std::span<const std::int64_t> numbers) {
  std::string bytes;
  pq::put_varint(bytes, kBlock);
  pq::put_varint(bytes, kParts);
  pq::put_varint(bytes, numbers.size());
  pq::put_signed_varint(bytes, numbers.empty() ? 0 : numbers.front());
  std::vector<std::int64_t> block;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    block.push_back(
        static_cast<std::int64_t>(static_cast<std::uint64_t>(numbers[i]) - static_cast<std::uint64_t>(numbers[i - 1])));
    if (block.size() < kBlock && i + 1 < numbers.size()) continue;
    put_block(bytes, block);
    block.clear();
  }
  return bytes;
}

std::vector<std::int64_t> from_delta(std::string_view bytes, std::size_t count) {
  const DeltaHead head = take_head(bytes, count);
  auto number = static_cast<std::uint64_t>(pq::take_signed_varint(bytes));
  std::vector<std::int64_t> numbers;
  if (count > 0) numbers.push_back(static_cast<std::int64_t>(number));
  const std::uint64_t part = head.block / head.parts;
  while (numbers.size() < count) {
    const auto least = static_cast<std::uint64_t>(pq::take_signed_varint(bytes));
    if (head.parts > bytes.size()) throw Error("is damaged: it ends within a block");
    const std::string_view widths = bytes.substr(0, head.parts);
    bytes.remove_prefix(head.parts);
    for (std::size_t p = 0; p < head.parts && numbers.size() < count; ++p) {
      const int bits = static_cast<unsigned char>(widths[p]);
      const std::uint64_t size = part / 8 * static_cast<std::uint64_t>(bits);
      if (bits > 64 || size > bytes.size()) throw Error("is damaged: it ends within a block");
      PackedReader packed(bytes.substr(0, size), bits);
      for (std::uint64_t i = 0; i < part && numbers.size() < count; ++i)
        numbers.push_back(static_cast<std::int64_t>(number += least + packed.next()));
      bytes.remove_prefix(size);
    }
  }
  return numbers;
}

}  // namespace taxel
