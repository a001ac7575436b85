// The pages of one column of one row group.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/run/parquet/metadata.h"
#include "core/run/parquet/parquet.h"

namespace taxel {

/// Encodes a column. Plain values, a dictionary and split streams are tried, and the smallest is kept; equal cells give
/// equal bytes. Throws Error if values, lengths and `column` do not fit together.
EncodedColumn encode_column(const ParquetColumn& column, const ParquetCells& cells);

/// How deep the values of a column are in optional and repeated parts of the schema.
struct ParquetLevels {
  int max_definition = 0;   ///< level of a value that is present
  int max_repetition = 0;   ///< 1 for a list
  int list_definition = 0;  ///< smallest level of a list with values
};

/// Memory for decoded values. A dictionary repeats a long text by a few bytes, and pages are compressed, so that the
/// size of a file does not limit the size of its values.
class DecodedBytes {
 public:
  explicit DecodedBytes(std::uint64_t most) : most_(most), left_(most) {}
  /// Takes memory before it is allocated. Throws Error if there is too little left.
  void take(std::uint64_t count, std::uint64_t bytes_of_each);

 private:
  std::uint64_t most_, left_;
};

/// Appends values of the same type.
void append_values(ParquetValues& all, ParquetValues more);

/// Decodes the pages of a column. `rows` is the number of rows that the row group has. Throws Error if the pages are
/// damaged, if values are missing, for an encoding or a codec that is not read, or if the values need more than
/// `memory` has.
ParquetCells decode_column(const ParquetColumn& column, const ParquetLevels& levels, const EncodedColumn& encoded,
                           std::int64_t rows, DecodedBytes& memory);

}  // namespace taxel

namespace taxel::parquet {

/// A column as the schema of a file describes it, and how deep its values are.
struct ColumnPlace {
  ParquetColumn column;
  ParquetLevels levels;
};

/// Returns the number of a type in files.
int type_number(ParquetType type);

/// Returns the schema of columns. A list has the three levels that the format prescribes.
std::vector<SchemaElement> schema_of(const std::vector<ParquetColumn>& columns);

/// Returns the names on the way from the root of schema_of() to the values of a column.
std::vector<std::string> path_of(const ParquetColumn& column);

/// Returns the columns of a schema. Throws Error naming a column of a type or a structure that is not read.
std::vector<ColumnPlace> read_schema(const std::vector<SchemaElement>& schema);

}  // namespace taxel::parquet
