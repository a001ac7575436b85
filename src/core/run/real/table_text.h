// A table of numbers as text: its lines taken apart, and what its fields say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text/csv.h"
#include "core/run/real/column_mapping.h"

namespace taxel {

struct TextTable {
  std::vector<std::string> columns;  ///< as the last header line names them; "#1", "#2", ... where none does
  std::vector<CsvRow> rows;          ///< behind the header
};

/// Throws Error(file, "line N", ...) for text that is no table, or has no line behind its header.
TextTable split_table(const std::string& text, const ColumnMapping& mapping, const std::string& file);

/// A finite number, with this decimal mark; none: it is something else.
std::optional<double> number_of(const std::string& field, char decimal);
/// Empty, or a word for nothing.
bool is_missing(const std::string& field);
/// 2 of "#3".
std::optional<std::size_t> numbered_column(const std::string& name);

}  // namespace taxel
