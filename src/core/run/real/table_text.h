// Splits a table of a real sensor into rows with one time and one column for each taxel.
#pragma once

#include <string>
#include <vector>

#include "core/base/text/number_table.h"
#include "core/run/real/column_mapping.h"

namespace taxel {

struct TextTable {
  std::vector<std::string> columns;  ///< names in the last header line; "#1", "#2", ... without a header
  std::vector<CsvRow> rows;          ///< rows after the header
  std::vector<std::string> notes;    ///< sentences on columns that reshape_table() has changed
};

/// Splits a text into a table in the form of reshape_table(). Throws Error(file, "line N", ...) if the text is not a
/// table or has no row after the header, or as reshape_table() does.
TextTable split_table(const std::string& text, const ColumnMapping& mapping, const std::string& file);

/// Brings tables of other forms into the form of one row for each time and one column for each taxel:
/// - The columns `P.sec` and `P.nanosec` (secs and nsecs, and so on, in any order) become one column `P [s]`.
/// - Times of ISO 8601 become seconds since 1970; the name of the column ends in [s].
/// - A column `P` of lists in brackets becomes the columns `P[0]`, `P[1]`, ...
/// - A table with columns of a time, a taxel and a value, one value in each row, gets a column `taxel_ID` for each
///   taxel (or its name), and a row for each time.
/// Throws Error naming `file`, line and column if lists differ in length, or if a taxel has two values at one time.
void reshape_table(TextTable& table, const std::string& file);

/// Returns true if the name is that of a column of times.
bool names_time(const std::string& column);
/// Returns the index of a column that is named by its number: 2 for "#3". Returns nothing for other names.
std::optional<std::size_t> numbered_column(const std::string& name);

}  // namespace taxel
