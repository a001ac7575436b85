#include "core/run/parquet/schema.h"

#include "core/base/error.h"

namespace taxel::parquet {
namespace {

SchemaElement leaf_of(const ParquetColumn& column, const std::string& name) {
  SchemaElement leaf{type_number(column.type), kRequired, name, {}, {}};
  if (column.type == ParquetType::text) leaf.converted = kUtf8;
  return leaf;
}

/// Finds the columns of a schema. A column is a value, or a list of values with the levels that the format prescribes.
class SchemaReader {
 public:
  explicit SchemaReader(const std::vector<SchemaElement>& schema) : schema_(schema) {}

  std::vector<ColumnPlace> read() {
    const SchemaElement& root = next();
    std::vector<ColumnPlace> columns;
    for (int i = 0; i < root.children.value_or(0); ++i) columns.push_back(read_column());
    if (at_ != schema_.size()) throw Error("is damaged: the schema has parts without a place");
    return columns;
  }

 private:
  const SchemaElement& next() {
    if (at_ >= schema_.size()) throw Error("is damaged: the schema ends early");
    return schema_[at_++];
  }

  static ParquetType type_of(const SchemaElement& leaf) {
    switch (leaf.type.value_or(-1)) {
      case kInt64:
        return ParquetType::int64;
      case kFloat:
        return ParquetType::float32;
      case kDouble:
        return ParquetType::float64;
      case kByteArray:
        return ParquetType::text;
      default:
        throw Error("", leaf.name, "has a type that is not read; int64, float, double and string are read");
    }
  }

  static int optional_level(const SchemaElement& element) {
    if (element.repetition == kRepeated) throw Error("", element.name, "is repeated, but not as a list");
    return element.repetition == kOptional ? 1 : 0;
  }

  ColumnPlace read_column() {
    const SchemaElement& element = next();
    const int level = optional_level(element);
    if (element.children.value_or(0) == 0) return {{element.name, type_of(element), false}, {level, 0, 0}};
    const SchemaElement& list = next();
    if (element.children != 1 || list.children != 1 || list.repetition != kRepeated)
      throw Error("", element.name, "is a structure, which is not read; values and lists of values are read");
    const SchemaElement& item = next();
    if (item.children.value_or(0) != 0) throw Error("", element.name, "is a list of lists, which is not read");
    return {{element.name, type_of(item), true}, {level + 1 + optional_level(item), 1, level + 1}};
  }

  const std::vector<SchemaElement>& schema_;
  std::size_t at_ = 0;
};

}  // namespace

int type_number(ParquetType type) {
  constexpr int kNumbers[] = {kInt64, kFloat, kDouble, kByteArray};
  return kNumbers[static_cast<std::size_t>(type)];
}

std::vector<SchemaElement> schema_of(const std::vector<ParquetColumn>& columns) {
  std::vector<SchemaElement> schema{{{}, {}, "schema", static_cast<int>(columns.size()), {}}};
  for (const ParquetColumn& column : columns) {
    if (!column.is_list) {
      schema.push_back(leaf_of(column, column.name));
      continue;
    }
    schema.push_back({{}, kRequired, column.name, 1, kList});
    schema.push_back({{}, kRepeated, "list", 1, {}});
    schema.push_back(leaf_of(column, "element"));
  }
  return schema;
}

std::vector<std::string> path_of(const ParquetColumn& column) {
  return column.is_list ? std::vector<std::string>{column.name, "list", "element"} : std::vector{column.name};
}

std::vector<ColumnPlace> read_schema(const std::vector<SchemaElement>& schema) {
  return SchemaReader(schema).read();
}

}  // namespace taxel::parquet
