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
