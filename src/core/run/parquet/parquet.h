// Tables in Apache Parquet files (https://parquet.apache.org/docs/file-format): a part of the format that pandas,
// pyarrow, DuckDB and others read.
//
// Written: columns of whole numbers, floating-point numbers and texts, and lists of them, without missing values; one
// page for each column of a row group, compressed with Zstandard. Also read: files of other programs with the same
// types, several pages, and optional columns without missing values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace taxel {

enum class ParquetType { int64, float32, float64, text };

struct ParquetColumn {
  std::string name;
  ParquetType type = ParquetType::float64;
  bool is_list = false;  ///< each row has a list of values
  bool operator==(const ParquetColumn&) const = default;
};

/// The values of a column, of all rows one after the other. The alternatives are in the order of ParquetType.
using ParquetValues =
    std::variant<std::vector<std::int64_t>, std::vector<float>, std::vector<double>, std::vector<std::string>>;

/// The rows of one column in one row group.
struct ParquetCells {
  ParquetValues values;
  std::vector<std::int32_t> lengths = {};  ///< length of each row's list; empty for a column without lists
  bool operator==(const ParquetCells&) const = default;

  /// Returns the number of rows.
  [[nodiscard]] std::size_t rows() const;
};

/// Returns the number of values.
std::size_t count_of(const ParquetValues& values);

/// Returns cells of lists that all have the length `width`.
ParquetCells lists_of(ParquetValues values, std::size_t width);

/// Texts in the footer of a file, by key.
using ParquetNotes = std::vector<std::pair<std::string, std::string>>;

/// One column of one row group as it is in a file: pages and their description. It can be moved to another file.
struct EncodedColumn {
  std::string pages;
  std::int64_t values = 0;                     ///< number of values; an empty list is one
  std::int64_t uncompressed_bytes = 0;         ///< size of `pages` before the compression
  std::int64_t dictionary_bytes = 0;           ///< size of the dictionary page at the begin of `pages`, or 0
  std::vector<int> encodings;                  ///< numbers of the encodings (metadata.h)
  int codec = 0;                               ///< 6 for Zstandard, 0 without compression
  std::string min_value = {}, max_value = {};  ///< plain bytes of the limits; empty if they are not known
};

}  // namespace taxel
