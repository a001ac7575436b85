#include "core/run/parquet/encodings.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <unordered_map>

#include "core/base/error.h"

static_assert(std::endian::native == std::endian::little, "Parquet files are little endian");

namespace taxel {
namespace {

constexpr int kCompressionLevel = 9;

Error too_short() {
  return Error("the page has fewer bytes than its values need");
}

template <class Number>
void append_number(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}

template <class Number>
ParquetValues numbers_from_plain(std::size_t count, std::string_view bytes) {
  if (bytes.size() / sizeof(Number) < count) throw too_short();
  std::vector<Number> numbers(count);
  if (count > 0) std::memcpy(numbers.data(), bytes.data(), count * sizeof(Number));
  return numbers;
}

ParquetValues texts_from_plain(std::size_t count, std::string_view bytes) {
  if (bytes.size() / 4 < count) throw too_short();
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t size = 0;
    if (bytes.size() < sizeof size) throw too_short();
    std::memcpy(&size, bytes.data(), sizeof size);
    bytes.remove_prefix(sizeof size);
    if (bytes.size() < size) throw too_short();
    texts.emplace_back(bytes.substr(0, size));
    bytes.remove_prefix(size);
  }
  return texts;
}

/// Packs eight numbers, the first one in the lowest bits.
void append_packed(std::string& bytes, const std::uint32_t* numbers, int bits) {
  std::uint64_t buffer = 0;
  int filled = 0;
  for (int i = 0; i < 8; ++i) {
    buffer |= std::uint64_t{numbers[i]} << filled;
    for (filled += bits; filled >= 8; filled -= 8, buffer >>= 8) bytes += static_cast<char>(buffer);
  }
}

void take_packed(std::string_view bytes, int bits, std::vector<std::uint32_t>& numbers) {
  std::uint64_t buffer = 0;
  int filled = 0;
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  for (const char byte : bytes) {
    buffer |= std::uint64_t{static_cast<unsigned char>(byte)} << filled;
    for (filled += 8; filled >= bits; filled -= bits, buffer >>= bits)
      numbers.push_back(static_cast<std::uint32_t>(buffer & mask));
  }
}

/// Appends whole groups of eight numbers; the last group may be filled with zeros.
void append_groups(std::string& bytes, std::span<const std::uint32_t> numbers, int bits) {
  if (numbers.empty()) return;
  const std::size_t groups = (numbers.size() + 7) / 8;
  parquet::put_varint(bytes, groups << 1 | 1);
  for (std::size_t g = 0; g < groups; ++g) {
    std::uint32_t eight[8] = {};
    const std::size_t first = 8 * g;
    for (std::size_t i = first; i < std::min(first + 8, numbers.size()); ++i) eight[i - first] = numbers[i];
    append_packed(bytes, eight, bits);
  }
}

template <class Value>
struct BitEqual {
  bool operator()(const Value& a, const Value& b) const {
    if constexpr (std::is_same_v<Value, std::string>)
      return a == b;
    else
      return std::memcmp(&a, &b, sizeof a) == 0;
  }
};
template <class Value>
struct BitHash {
  std::size_t operator()(const Value& value) const {
    if constexpr (std::is_same_v<Value, std::string>)
      return std::hash<std::string>{}(value);
    else
      return std::hash<std::string_view>{}({reinterpret_cast<const char*>(&value), sizeof value});
  }
};

struct EndContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

}  // namespace

std::size_t count_of(const ParquetValues& values) {
  return std::visit([](const auto& all) { return all.size(); }, values);
}

std::size_t ParquetCells::rows() const {
  return lengths.empty() ? count_of(values) : lengths.size();
}

ParquetCells lists_of(ParquetValues values, std::size_t width) {
  const std::size_t rows = width > 0 ? count_of(values) / width : 0;
  return {std::move(values), std::vector<std::int32_t>(rows, static_cast<std::int32_t>(width))};
}

std::string plain_bytes(const ParquetValues& values) {
  std::string bytes;
  const auto append = [&](const auto& all) {
    using Value = std::remove_cvref_t<decltype(all[0])>;
    if constexpr (std::is_same_v<Value, std::string>) {
      for (const std::string& text : all) {
        append_number(bytes, static_cast<std::uint32_t>(text.size()));
        bytes += text;
      }
    } else {
      bytes.assign(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(Value));
    }
  };
  std::visit(append, values);
  return bytes;
}

ParquetValues from_plain(ParquetType type, std::size_t count, std::string_view bytes) {
  switch (type) {
    case ParquetType::int64:
      return numbers_from_plain<std::int64_t>(count, bytes);
    case ParquetType::float32:
      return numbers_from_plain<float>(count, bytes);
    case ParquetType::float64:
      return numbers_from_plain<double>(count, bytes);
    case ParquetType::text:
      break;
  }
  return texts_from_plain(count, bytes);
}

std::string split_streams(std::string_view plain, std::size_t width) {
  const std::size_t count = plain.size() / width;
  std::string split(plain.size(), '\0');
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < width; ++b) split[b * count + i] = plain[i * width + b];
  return split;
}

std::string joined_streams(std::string_view split, std::size_t width) {
  if (split.size() % width != 0) throw Error("the streams of a page have different lengths");
  const std::size_t count = split.size() / width;
  std::string plain(split.size(), '\0');
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < width; ++b) plain[i * width + b] = split[b * count + i];
  return plain;
}

int bits_for(std::uint32_t count) {
  return std::max(1, static_cast<int>(std::bit_width(count > 0 ? count - 1 : 0U)));
}

std::string packed_runs(std::span<const std::uint32_t> numbers, int bits) {
  constexpr std::size_t kShortestRun = 16;  // a shorter run is not smaller than packed numbers
  std::string bytes;
  std::size_t pending = 0;  // first number that is not written
  for (std::size_t begin = 0; begin < numbers.size();) {
    std::size_t end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[begin]) ++end;
    // Packed numbers before a run come in whole groups, so a run may give up its first numbers.
    const std::size_t start = pending + (begin - pending + 7) / 8 * 8;
    if (end >= start + kShortestRun) {
      append_groups(bytes, numbers.subspan(pending, start - pending), bits);
      parquet::put_varint(bytes, (end - start) << 1);
      const std::uint32_t number = numbers[begin];
      for (int b = 0; b < (bits + 7) / 8; ++b) bytes += static_cast<char>(number >> (8 * b));
      pending = end;
    }
    begin = end;
  }
  append_groups(bytes, numbers.subspan(pending), bits);
  return bytes;
}

std::vector<std::uint32_t> from_packed_runs(std::string_view bytes, int bits, std::size_t count) {
  if (bits < 0 || bits > 32) throw Error(fmt::format("numbers of {} bits, at most 32 are possible", bits));
  if (bits == 0) return std::vector<std::uint32_t>(count, 0U);
  std::vector<std::uint32_t> numbers;
  while (numbers.size() < count) {
    const std::uint64_t head = parquet::take_varint(bytes), length = head >> 1;
    if ((head & 1) != 0) {
      const std::uint64_t size = length * static_cast<std::uint64_t>(bits);
      if (length == 0 || size > bytes.size()) throw too_short();
      take_packed(bytes.substr(0, size), bits, numbers);
      bytes.remove_prefix(size);
      continue;
    }
    const auto width = static_cast<std::size_t>((bits + 7) / 8);
    if (length == 0 || bytes.size() < width || length > count - numbers.size()) throw too_short();
    std::uint32_t number = 0;
    for (std::size_t b = 0; b < width; ++b)
      number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[b])) << (8 * b);
    bytes.remove_prefix(width);
    numbers.insert(numbers.end(), length, number);
  }
  numbers.resize(count);
  return numbers;
}

ParquetDictionary dictionary_of(const ParquetValues& values, std::size_t most) {
  ParquetDictionary dictionary;
  const auto build = [&]<class Value>(const std::vector<Value>& all) {
    std::unordered_map<Value, std::uint32_t, BitHash<Value>, BitEqual<Value>> index_of_value;
    std::vector<Value> distinct;
    dictionary.indices.reserve(all.size());
    for (const Value& value : all) {
      const auto [at, is_new] = index_of_value.try_emplace(value, static_cast<std::uint32_t>(distinct.size()));
      if (is_new) distinct.push_back(value);
      if (distinct.size() > most) break;
      dictionary.indices.push_back(at->second);
    }
    if (distinct.size() > most) dictionary.indices.clear();
    dictionary.values = std::move(distinct);
  };
  std::visit(build, values);
  return dictionary;
}

ParquetValues from_dictionary(const ParquetValues& dictionary, std::span<const std::uint32_t> indices) {
  const auto look_up = [&]<class Value>(const std::vector<Value>& distinct) -> ParquetValues {
    std::vector<Value> values;
    values.reserve(indices.size());
    for (const std::uint32_t index : indices) {
      if (index >= distinct.size()) throw Error(fmt::format("value {} of a dictionary of {}", index, distinct.size()));
      values.push_back(distinct[index]);
    }
    return values;
  };
  return std::visit(look_up, dictionary);
}

std::string zstd_compressed(std::string_view bytes) {
  thread_local const std::unique_ptr<ZSTD_CCtx, EndContext> context(ZSTD_createCCtx());
  if (context == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kCompressionLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string compressed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), compressed.data(), compressed.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) throw Error(fmt::format("Zstandard: {}", ZSTD_getErrorName(size)));
  compressed.resize(size);
  return compressed;
}

std::string zstd_uncompressed(std::string_view bytes, std::size_t size) {
  const unsigned long long announced = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (announced == ZSTD_CONTENTSIZE_ERROR) throw Error("is damaged: a page is not compressed with Zstandard");
  if (announced != ZSTD_CONTENTSIZE_UNKNOWN && announced != size)
    throw Error(fmt::format("is damaged: a page has {} bytes where {} are announced", announced, size));
  std::string uncompressed(size, '\0');
  const std::size_t written = ZSTD_decompress(uncompressed.data(), size, bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0) throw Error(fmt::format("is damaged: {}", ZSTD_getErrorName(written)));
  if (written != size) throw Error(fmt::format("has {} bytes where {} are announced", written, size));
  return uncompressed;
}

}  // namespace taxel

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
