#include "core/run/parquet/metadata.h"

#include "core/run/parquet/compact.h"

namespace taxel::parquet {
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
