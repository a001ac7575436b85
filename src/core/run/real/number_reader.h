// Reads the numbers of a table that was split into fields.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/run/real/column_mapping.h"
#include "core/run/real/table_text.h"

namespace taxel {

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
