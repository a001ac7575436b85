// A recording from a real sensor, read from a table of numbers whose columns a ColumnMapping explains.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/run/real/column_mapping.h"
#include "core/run/recording/recording.h"

namespace taxel {

/// Values of taxels over time, from a simulated run or a real sensor.
struct TaxelSeries {
  std::string unit;                         ///< unit of the values; empty if unknown
  std::vector<double> time;                 ///< times of the rows, ascending [s]
  std::vector<int> taxel_ids;               ///< ids of the taxels; no id appears twice
  std::vector<std::vector<double>> values;  ///< for each taxel, one value per row; NaN if missing
};

/// Smallest length of a gap, in median intervals. Values are not interpolated across a gap.
inline constexpr double kGapIntervals = 5;

/// Linear interpolation of the values of one taxel.
class Interpolated {
 public:
  /// Copies the values of `series` that are not missing. `taxel` is an index in TaxelSeries::values.
  Interpolated(const TaxelSeries& series, std::size_t taxel);
  /// Returns the value at a time, linear between the previous and the next value; NaN outside the series and in a gap.
  [[nodiscard]] double at(double time) const;

 private:
  std::vector<double> time_, value_;  // times [s] and values that are not missing
  double gap_;                        // smallest length of a gap [s]
};

/// Returns the median interval between two rows [s]; 0 if there are fewer than two rows.
double median_interval(const std::vector<double>& time);

/// Returns the readings of one sensor of a recording.
TaxelSeries series_of(const Recording& recording, std::size_t sensor);

/// Returns the difference of the largest and the smallest value, without missing values; 0 if all are missing.
double range_of(const std::vector<double>& values);

struct RealRecording {
  TaxelSeries series;              ///< taxels in the order of the mapping; times of the table
  std::vector<std::string> notes;  ///< sentences about missing values
};

/// Reads a recording from the text of a table of any form of reshape_table(). Empty fields and "nan", "NA", "null" and
/// "-" are missing values. A row with the time of the previous row is left out. Times of a clock, which counts from
/// 1970, count from the first row. The notes name the columns that are not read. Throws Error(file, "line 7, column
/// \"p3\"", ...) if a field is not a number, a row has another length, a time is missing or decreases, a column does
/// not exist, or the table has no rows.
RealRecording parse_real_recording(const std::string& text, const ColumnMapping& mapping, const std::string& file);

/// Names and first rows of a table, shown to a user who writes a mapping.
struct TableLook {
  std::vector<std::string> columns;            ///< names, or "#1", "#2", ... if the table has no header
  std::vector<std::vector<std::string>> rows;  ///< fields of the first rows, as text
};
/// Returns the names and at most `most_rows` rows of a table. Throws Error as split_table() does.
TableLook look_at_table(const std::string& text, const ColumnMapping& mapping, const std::string& file,
                        std::size_t most_rows);

/// Guesses the mapping from the names and the first rows of a table: the separator, the header lines, the column of
/// times by its name, and the unit of time by the name ("t [ms]") or by the interval of the rows. A taxel gets the
/// column whose name ends in its id ("taxel_3", "p3 [kPa]", "values[3]"); columns numbered from 1 for ids from 0, and
/// names of rows and columns (r0c0) of a grid of all taxels, are recognised. If no name has a number, as many columns
/// as taxels are taken in order. Without a column of times there is no rate: rows do not say how fast they follow each
/// other. Values that cannot be guessed keep their defaults; nothing is thrown.
ColumnMapping guess_mapping(const std::string& table, const std::vector<int>& taxel_ids);

/// Returns the taxels for which the mapping names no column.
std::vector<int> taxels_without_column(const ColumnMapping& mapping, std::vector<int> taxel_ids);

}  // namespace taxel
