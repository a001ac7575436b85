// The descriptions in a Parquet file, written by Apache Thrift's compact protocol. Names and meaning are those of
// parquet.thrift in the format's specification; parts that this program does not use are left out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/parquet/parquet.h"

namespace taxel::parquet {

// Structs in the compact protocol
// (https://github.com/apache/thrift/blob/master/doc/specs/thrift-compact-protocol.md).
//
// A struct is a list of fields, each with a number and a type, and ends with a zero. Numbers are written with seven
// bits in a byte, and signed numbers alternate: 0, -1, 1, -2 are written as 0, 1, 2, 3.

/// Types of fields and of the values of lists. The value of a truth field is its type.
enum class Compact : std::uint8_t {
  stop = 0,
  yes = 1,
  no = 2,
  byte = 3,
  i16 = 4,
  i32 = 5,
  i64 = 6,
  number = 7,
  text = 8,
  list = 9,
  set = 10,
  map = 11,
  structure = 12
};

/// Writes structs. The fields of a struct are written in ascending order of their numbers.
class CompactWriter {
 public:
  /// Writes a struct whose fields write() adds.
  template <class Write>
  void structure(const Write& write) {
    const int outer = last_id_;
    last_id_ = 0;
    write();
    bytes_ += '\0';
    last_id_ = outer;
  }
  template <class Write>
  void structure(int id, const Write& write) {
    field(id, Compact::structure);
    structure(write);
  }
  void i32(int id, std::int64_t value);
  void i32(int id, const std::optional<int>& value) {
    if (value) i32(id, std::int64_t{*value});
  }
  void i64(int id, std::int64_t value);
  void text(int id, std::string_view value);
  void i32s(int id, const std::vector<int>& values);
  void texts(int id, const std::vector<std::string>& values);
  /// Writes a list of structs, whose fields write(item) adds.
  template <class Items, class Write>
  void structures(int id, const Items& items, const Write& write) {
    list(id, Compact::structure, items.size());
    for (const auto& item : items) structure([&] { write(item); });
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void field(int id, Compact type);
  void list(int id, Compact type, std::size_t size);
  void put_text(std::string_view value);

  std::string bytes_;
  int last_id_ = 0;
};

/// Reads structs. Throws Error if the bytes end early, or a part is nested too deeply.
class CompactReader {
 public:
  explicit CompactReader(std::string_view bytes) : bytes_(bytes) {}

  /// Calls read(id, type) for each field of a struct. `read` returns false if it has not consumed the field, which is
  /// then skipped. Throws Error as the class says.
  template <class Read>
  void structure(const Read& read) {
    enter();
    int id = 0;
    for (Compact type = next_field(id); type != Compact::stop; type = next_field(id))
      if (!read(id, type)) skip(type);
    leave();
  }
  // Each of the following functions returns false if the field has another type.
  /// Reads a number. Throws Error if the bytes end early or the number has more than 32 bits.
  bool take(Compact type, int& value);
  /// Reads a number that may be missing. Throws Error as above.
  bool take(Compact type, std::optional<int>& value) { return take(type, value.emplace()); }
  /// Reads a number. Throws Error if the bytes end early.
  bool take(Compact type, std::int64_t& value);
  /// Reads a number that may be missing. Throws Error as above.
  bool take(Compact type, std::optional<std::int64_t>& value) { return take(type, value.emplace()); }
  /// Reads a text. Throws Error if the bytes end early.
  bool take(Compact type, std::string& value);
  /// Reads a list of numbers. Throws Error as for one number, or if the list has values of another type.
  bool take(Compact type, std::vector<int>& values);
  /// Reads a list of texts. Throws Error as for one text, or if the list has values of another type.
  bool take(Compact type, std::vector<std::string>& values);
  template <class Read>
  bool take_structure(Compact type, const Read& read) {
    if (type != Compact::structure) return false;
    structure(read);
    return true;
  }
  /// Calls read() for each struct of a list, which read() consumes.
  template <class Read>
  bool take_structures(Compact type, const Read& read) {
    if (type != Compact::list) return false;
    for (std::size_t left = list_of(Compact::structure); left > 0; --left) read();
    return true;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  /// Begins a nested part. Throws Error if the nesting is too deep.
  void enter();
  void leave() { --depth_; }
  Compact next_field(int& id);
  std::size_t list_of(Compact type);
  void skip(Compact type);
  void skip_items(Compact type, std::size_t count);
  std::uint8_t next_byte();
  std::string_view next_bytes(std::uint64_t size);

  std::string_view bytes_;
  int depth_ = 0;
};

// Numbers of the format's enumerations.
inline constexpr int kInt64 = 2, kFloat = 4, kDouble = 5, kByteArray = 6;             // Type
inline constexpr int kRequired = 0, kOptional = 1, kRepeated = 2;                     // FieldRepetitionType
inline constexpr int kUtf8 = 0, kList = 3;                                            // ConvertedType
inline constexpr int kPlain = 0, kPlainDictionary = 2, kRle = 3, kRleDictionary = 8;  // Encoding
inline constexpr int kDeltaBinaryPacked = 5, kByteStreamSplit = 9;
inline constexpr int kUncompressed = 0, kZstd = 6;        // CompressionCodec
inline constexpr int kDataPage = 0, kDictionaryPage = 2;  // PageType

struct SchemaElement {
  std::optional<int> type;
  std::optional<int> repetition;
  std::string name;
  std::optional<int> children;
  std::optional<int> converted;
};

struct ColumnMeta {
  int type = 0;
  std::vector<int> encodings;
  std::vector<std::string> path;
  int codec = 0;
  std::int64_t values = 0;
  std::int64_t uncompressed_bytes = 0, compressed_bytes = 0;
  std::int64_t data_page = 0;                   ///< offset in the file
  std::optional<std::int64_t> dictionary_page;  ///< offset in the file
  std::string min_value, max_value;
};

struct RowGroupMeta {
  std::vector<ColumnMeta> columns;
  std::int64_t bytes = 0, compressed_bytes = 0, rows = 0;
};

struct FileMeta {
  std::vector<SchemaElement> schema;  ///< depth first, the root first
  std::int64_t rows = 0;
  std::vector<RowGroupMeta> row_groups;
  ParquetNotes notes;
  std::string created_by;
};

struct PageHeader {
  int type = 0;
  int uncompressed_bytes = 0, compressed_bytes = 0;
  int values = 0;    ///< number of values of a data page or a dictionary page
  int encoding = 0;  ///< encoding of the values
};

std::string to_bytes(const FileMeta& meta);
std::string to_bytes(const PageHeader& header);
/// Read a description. Throw Error if the bytes are not one.
FileMeta file_meta_from(std::string_view bytes);
/// Removes the bytes of the header from the begin of `bytes`.
PageHeader take_page_header(std::string_view& bytes);

}  // namespace taxel::parquet
