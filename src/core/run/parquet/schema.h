// The columns of a Parquet file as its schema describes them.
#pragma once

#include <string>
#include <vector>

#include "core/run/parquet/column_codec.h"
#include "core/run/parquet/metadata.h"

namespace taxel::parquet {

/// A column, and how deep its values are.
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
