// A table of a real sensor: its text split into rows with one time and one column for each taxel, and its numbers.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/base/text/table.h"
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

/// Numbers and times of a table. An error names the file, the line and the column of the field that is not valid.
/// Refers to the table, the mapping and the name of the file, which must outlive the reader.
class NumberReader {
 public:
  NumberReader(const TextTable& table, const ColumnMapping& mapping, const std::string& file)
      : table_(table), mapping_(mapping), file_(file) {}

  /// Returns the index of a column by its name, or by its number ("#1"). Throws Error at `pointer` if there is no such
  /// column, or if several columns have the name.
  [[nodiscard]] std::size_t column(const std::string& name, const std::string& pointer) const;
  /// Throws Error that names line and column.
  [[noreturn]] void fail(const CsvRow& row, std::size_t column, const std::string& why) const;
  /// Throws Error if a row has another number of fields than the table has columns.
  void check_widths() const;
  /// Returns the number in a field, or NaN if the value is missing. Throws Error if the field is not a number.
  [[nodiscard]] double at(const CsvRow& row, std::size_t column) const;
  /// Returns the times of all rows [s]. Times of a clock, which counts from 1970, count from the first row without
  /// rounding, and a note is added. Throws Error if a time is missing or runs backwards.
  [[nodiscard]] std::vector<double> times(std::size_t column, std::vector<std::string>& notes) const;
  /// Returns the names of the columns that are not in `used`, for a note.
  [[nodiscard]] std::string names_without(const std::set<std::size_t>& used) const;

 private:
  [[nodiscard]] long double time_at(const CsvRow& row, std::size_t column) const;

  const TextTable& table_;
  const ColumnMapping& mapping_;
  const std::string& file_;
};

}  // namespace taxel
