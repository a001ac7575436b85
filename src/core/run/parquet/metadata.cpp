#include "core/run/parquet/metadata.h"

#include <fmt/format.h>

#include <limits>

#include "core/base/error.h"
#include "core/run/parquet/encodings.h"

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

namespace {

void write(CompactWriter& w, const SchemaElement& element) {
  constexpr int kStringType = 1, kListType = 3;  // alternatives of LogicalType
  w.i32(1, element.type);
  w.i32(3, element.repetition);
  w.text(4, element.name);
  w.i32(5, element.children);
  w.i32(6, element.converted);
  if (element.converted)
    w.structure(10, [&] { w.structure(*element.converted == kUtf8 ? kStringType : kListType, [] {}); });
}

void write(CompactWriter& w, const ColumnMeta& column) {
  w.i32(1, column.type);
  w.i32s(2, column.encodings);
  w.texts(3, column.path);
  w.i32(4, column.codec);
  w.i64(5, column.values);
  w.i64(6, column.uncompressed_bytes);
  w.i64(7, column.compressed_bytes);
  w.i64(9, column.data_page);
  if (column.dictionary_page) w.i64(11, *column.dictionary_page);
  if (column.min_value.empty()) return;
  w.structure(12, [&] {
    w.i64(3, 0);  // number of missing values
    w.text(5, column.max_value);
    w.text(6, column.min_value);
  });
}

void write(CompactWriter& w, const RowGroupMeta& group) {
  w.structures(1, group.columns, [&](const ColumnMeta& column) {
    w.i64(2, 0);  // the description is not repeated at the pages
    w.structure(3, [&] { write(w, column); });
  });
  w.i64(2, group.bytes);
  w.i64(3, group.rows);
  w.i64(6, group.compressed_bytes);
}

void read(CompactReader& r, SchemaElement& element) {
  r.structure([&](int id, Compact type) {
    switch (id) {
      case 1:
        return r.take(type, element.type);
      case 3:
        return r.take(type, element.repetition);
      case 4:
        return r.take(type, element.name);
      case 5:
        return r.take(type, element.children);
      case 6:
        return r.take(type, element.converted);
      default:
        return false;
    }
  });
}

bool read_field(CompactReader& r, int id, Compact type, ColumnMeta& column) {
  switch (id) {
    case 1:
      return r.take(type, column.type);
    case 2:
      return r.take(type, column.encodings);
    case 3:
      return r.take(type, column.path);
    case 4:
      return r.take(type, column.codec);
    case 5:
      return r.take(type, column.values);
    case 6:
      return r.take(type, column.uncompressed_bytes);
    case 7:
      return r.take(type, column.compressed_bytes);
    case 9:
      return r.take(type, column.data_page);
    case 11:
      return r.take(type, column.dictionary_page);
    case 12:
      return r.take_structure(type, [&](int inner, Compact inner_type) {
        return (inner == 5 && r.take(inner_type, column.max_value)) ||
               (inner == 6 && r.take(inner_type, column.min_value));
      });
    default:
      return false;
  }
}

void read(CompactReader& r, RowGroupMeta& group) {
  const auto read_column = [&] {
    ColumnMeta& column = group.columns.emplace_back();
    r.structure([&](int id, Compact type) {
      return id == 3 && r.take_structure(type, [&](int inner, Compact inner_type) {
        return read_field(r, inner, inner_type, column);
      });
    });
  };
  r.structure([&](int id, Compact type) {
    if (id == 1) return r.take_structures(type, read_column);
    if (id == 2) return r.take(type, group.bytes);
    if (id == 3) return r.take(type, group.rows);
    return id == 6 && r.take(type, group.compressed_bytes);
  });
}

bool read_field(CompactReader& r, int id, Compact type, FileMeta& meta) {
  switch (id) {
    case 2:
      return r.take_structures(type, [&] { read(r, meta.schema.emplace_back()); });
    case 3:
      return r.take(type, meta.rows);
    case 4:
      return r.take_structures(type, [&] { read(r, meta.row_groups.emplace_back()); });
    case 5:
      return r.take_structures(type, [&] {
        auto& [key, value] = meta.notes.emplace_back();
        r.structure([&](int inner, Compact inner_type) {
          return (inner == 1 && r.take(inner_type, key)) || (inner == 2 && r.take(inner_type, value));
        });
      });
    case 6:
      return r.take(type, meta.created_by);
    default:
      return false;
  }
}

}  // namespace

std::string to_bytes(const FileMeta& meta) {
  constexpr std::int32_t kVersion = 2;
  CompactWriter w;
  w.structure([&] {
    w.i32(1, kVersion);
    w.structures(2, meta.schema, [&](const SchemaElement& element) { write(w, element); });
    w.i64(3, meta.rows);
    w.structures(4, meta.row_groups, [&](const RowGroupMeta& group) { write(w, group); });
    w.structures(5, meta.notes, [&](const auto& note) {
      w.text(1, note.first);
      w.text(2, note.second);
    });
    w.text(6, meta.created_by);
    std::vector<int> leaves;
    for (const SchemaElement& element : meta.schema)
      if (element.type) leaves.push_back(*element.type);
    w.structures(7, leaves, [&](int) { w.structure(1, [] {}); });  // limits are in the order of the type
  });
  return w.bytes();
}

std::string to_bytes(const PageHeader& header) {
  CompactWriter w;
  w.structure([&] {
    w.i32(1, header.type);
    w.i32(2, header.uncompressed_bytes);
    w.i32(3, header.compressed_bytes);
    const bool is_data = header.type == kDataPage;
    w.structure(is_data ? 5 : 7, [&] {
      w.i32(1, header.values);
      w.i32(2, header.encoding);
      if (is_data) w.i32(3, kRle);
      if (is_data) w.i32(4, kRle);
    });
  });
  return w.bytes();
}

FileMeta file_meta_from(std::string_view bytes) {
  FileMeta meta;
  CompactReader r(bytes);
  r.structure([&](int id, Compact type) { return read_field(r, id, type, meta); });
  return meta;
}

PageHeader take_page_header(std::string_view& bytes) {
  PageHeader header;
  CompactReader r(bytes);
  r.structure([&](int id, Compact type) {
    if (id == 1) return r.take(type, header.type);
    if (id == 2) return r.take(type, header.uncompressed_bytes);
    if (id == 3) return r.take(type, header.compressed_bytes);
    return (id == 5 || id == 7) && r.take_structure(type, [&](int inner, Compact inner_type) {
      return (inner == 1 && r.take(inner_type, header.values)) || (inner == 2 && r.take(inner_type, header.encoding));
    });
  });
  bytes.remove_prefix(bytes.size() - r.left());
  return header;
}

}  // namespace taxel::parquet
