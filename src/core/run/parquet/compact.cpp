#include "core/run/parquet/compact.h"

#include <fmt/format.h>

#include <limits>

#include "core/base/error.h"
#include "core/run/parquet/varint.h"

namespace taxel::parquet {
namespace {

constexpr int kMaxDepth = 16;
constexpr std::size_t kShortList = 15;  // a longer list has its size in bytes of its own
constexpr int kLargestStep = 15;        // a larger step between field numbers is written as a number

}  // namespace

void CompactWriter::field(int id, Compact type) {
  const int step = id - last_id_;
  last_id_ = id;
  if (step > 0 && step <= kLargestStep) {
    bytes_ += static_cast<char>(step << 4 | static_cast<int>(type));
    return;
  }
  bytes_ += static_cast<char>(type);
  put_signed_varint(bytes_, id);
}

void CompactWriter::i32(int id, std::int64_t value) {
  field(id, Compact::i32);
  put_signed_varint(bytes_, value);
}

void CompactWriter::i64(int id, std::int64_t value) {
  field(id, Compact::i64);
  put_signed_varint(bytes_, value);
}

void CompactWriter::put_text(std::string_view value) {
  put_varint(bytes_, value.size());
  bytes_ += value;
}

void CompactWriter::text(int id, std::string_view value) {
  field(id, Compact::text);
  put_text(value);
}

void CompactWriter::list(int id, Compact type, std::size_t size) {
  field(id, Compact::list);
  const auto number = static_cast<unsigned>(type);
  if (size < kShortList) {
    bytes_ += static_cast<char>(size << 4 | number);
    return;
  }
  bytes_ += static_cast<char>(0xf0U | number);
  put_varint(bytes_, size);
}

void CompactWriter::i32s(int id, const std::vector<int>& values) {
  list(id, Compact::i32, values.size());
  for (const int value : values) put_signed_varint(bytes_, value);
}

void CompactWriter::texts(int id, const std::vector<std::string>& values) {
  list(id, Compact::text, values.size());
  for (const std::string& value : values) put_text(value);
}

void CompactReader::enter() {
  if (++depth_ > kMaxDepth) throw Error(fmt::format("is damaged: a description is nested deeper than {}", kMaxDepth));
}

std::string_view CompactReader::next_bytes(std::uint64_t size) {
  if (size > bytes_.size()) throw Error("is damaged: a description ends early");
  const std::string_view bytes = bytes_.substr(0, size);
  bytes_.remove_prefix(size);
  return bytes;
}

std::uint8_t CompactReader::next_byte() {
  return static_cast<std::uint8_t>(next_bytes(1).front());
}

Compact CompactReader::next_field(int& id) {
  const std::uint8_t head = next_byte();
  if (head == 0) return Compact::stop;
  const std::int64_t next = head >> 4 != 0 ? id + (head >> 4) : take_signed_varint(bytes_);
  if (next < 0 || next > std::numeric_limits<std::int16_t>::max())
    throw Error(fmt::format("is damaged: a description has a field {}", next));
  id = static_cast<int>(next);
  return static_cast<Compact>(head & 0xfU);
}

bool CompactReader::take(Compact type, int& value) {
  if (type != Compact::i32) return false;
  const std::int64_t number = take_signed_varint(bytes_);
  if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
    throw Error(fmt::format("is damaged: the number {} of a description has more than 32 bits", number));
  value = static_cast<int>(number);
  return true;
}

bool CompactReader::take(Compact type, std::int64_t& value) {
  if (type != Compact::i64) return false;
  value = take_signed_varint(bytes_);
  return true;
}

bool CompactReader::take(Compact type, std::string& value) {
  if (type != Compact::text) return false;
  value = next_bytes(take_varint(bytes_));
  return true;
}

bool CompactReader::take(Compact type, std::vector<int>& values) {
  if (type != Compact::list) return false;
  for (std::size_t left = list_of(Compact::i32); left > 0; --left) take(Compact::i32, values.emplace_back());
  return true;
}

bool CompactReader::take(Compact type, std::vector<std::string>& values) {
  if (type != Compact::list) return false;
  for (std::size_t left = list_of(Compact::text); left > 0; --left) take(Compact::text, values.emplace_back());
  return true;
}

/// Returns the number of values. Each value has at least one byte, so that a damaged number ends the reading early.
std::size_t CompactReader::list_of(Compact type) {
  const std::uint8_t head = next_byte();
  const std::uint64_t size = head >> 4 < static_cast<int>(kShortList) ? head >> 4 : take_varint(bytes_);
  if (size > 0 && static_cast<Compact>(head & 0xfU) != type)
    throw Error("is damaged: a list of a description has values of another type");
  if (size > bytes_.size()) throw Error("is damaged: a description ends early");
  return size;
}

void CompactReader::skip(Compact type) {
  switch (type) {
    case Compact::yes:
    case Compact::no:
      return;
    case Compact::byte:
      next_byte();
      return;
    case Compact::i16:
    case Compact::i32:
    case Compact::i64:
      take_varint(bytes_);
      return;
    case Compact::number:
      next_bytes(8);
      return;
    case Compact::text:
      next_bytes(take_varint(bytes_));
      return;
    case Compact::list:
    case Compact::set: {
      const std::uint8_t head = next_byte();
      const std::uint64_t size = head >> 4 < static_cast<int>(kShortList) ? head >> 4 : take_varint(bytes_);
      return skip_items(static_cast<Compact>(head & 0xfU), size);
    }
    case Compact::map: {
      const std::uint64_t size = take_varint(bytes_);
      const std::uint8_t types = size > 0 ? next_byte() : std::uint8_t{0};
      for (std::uint64_t i = 0; i < size; ++i) {
        skip_items(static_cast<Compact>(types >> 4), 1);
        skip_items(static_cast<Compact>(types & 0xfU), 1);
      }
      return;
    }
    case Compact::structure:
      return structure([](int, Compact) { return false; });
    case Compact::stop:
      break;
  }
  throw Error(fmt::format("is damaged: a description has a field of type {}", static_cast<int>(type)));
}

/// Skips values of a list. A truth value takes one byte there.
void CompactReader::skip_items(Compact type, std::size_t count) {
  enter();
  if (count > bytes_.size()) throw Error("is damaged: a description ends early");
  for (std::size_t i = 0; i < count; ++i) {
    if (type == Compact::yes || type == Compact::no)
      next_byte();
    else
      skip(type);
  }
  leave();
}

}  // namespace taxel::parquet
