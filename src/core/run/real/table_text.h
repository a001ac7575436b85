// Parsing of a table of numbers: the text is split into rows and fields, and fields are read as numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text/csv.h"
#include "core/run/real/column_mapping.h"

namespace taxel {

struct TextTable {
  std::vector<std::string> columns;  ///< names in the last header line; "#1", "#2", ... without a header
  std::vector<CsvRow> rows;          ///< rows after the header
};

/// Splits a text into a table. Throws Error(file, "line N", ...) if the text is not a table or has no row after the
/// header.
TextTable split_table(const std::string& text, const ColumnMapping& mapping, const std::string& file);

/// Returns the finite number in a field with this decimal mark, or nothing if the field is not such a number.
std::optional<double> number_of(const std::string& field, char decimal);
/// Returns true if the field is empty or is a word for a missing value, such as "nan".
bool is_missing(const std::string& field);
/// Returns the index of a column that is named by its number: 2 for "#3". Returns nothing for other names.
std::optional<std::size_t> numbered_column(const std::string& name);

}  // namespace taxel
