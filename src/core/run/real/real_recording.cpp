#include "core/run/real/real_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/real/table_text.h"

namespace taxel {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kSecondsOf{1.0L, 1e-3L, 1e-6L, 1e-9L};  // in the order of TimeUnit
constexpr double kLongestRun = 1e8;                          // three years: later times are those of a clock [s]

/// Reads the numbers of a table. An error names the line and the column of a field that is not a number.
class NumberReader {
 public:
  NumberReader(const TextTable& table, const ColumnMapping& mapping, const std::string& file)
      : table_(table), mapping_(mapping), file_(file) {}

  [[nodiscard]] std::size_t column(const std::string& name, const std::string& pointer) const {
    const std::vector<std::string>& names = table_.columns;
    if (const auto number = numbered_column(name); number && *number < names.size()) return *number;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw Error(file_, pointer, fmt::format("there is no column \"{}\"; there are {}", name, list(names)));
    if (std::find(found + 1, names.end(), name) != names.end())
      throw Error(
          file_, pointer,
          fmt::format("several columns are named \"{}\": give its number, as #{}", name, found - names.begin() + 1));
    return static_cast<std::size_t>(found - names.begin());
  }
  [[noreturn]] void fail(const CsvRow& row, std::size_t column, const std::string& why) const {
    throw Error(file_, fmt::format("line {}, column \"{}\"", row.line, table_.columns[column]), why);
  }
  [[nodiscard]] double at(const CsvRow& row, std::size_t column) const {
    const std::string& field = row.fields[column];
    if (is_missing(field)) return kMissing;
    const std::optional<double> number = number_of(field, mapping_.decimal.front());
    if (!number) fail(row, column, fmt::format("is no number: \"{}\"", field));
    return *number;
  }
  /// Returns the number in a field of times with more digits than a double has: stamps count from 1970.
  [[nodiscard]] long double time_at(const CsvRow& row, std::size_t column) const {
    const double rounded = at(row, column);
    std::string text = row.fields[column];
    std::replace(text.begin(), text.end(), ',', '.');
    long double exact = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exact);
    return error == std::errc() && !std::isnan(rounded) ? exact : rounded;
  }
  /// Returns the names of the columns that are not in `used`, for a note.
  [[nodiscard]] std::string names_without(const std::set<std::size_t>& used) const {
    std::vector<std::string> names;
    for (std::size_t c = 0; c < table_.columns.size(); ++c)
      if (!used.contains(c)) names.push_back(table_.columns[c]);
    return list(names);
  }

 private:
  static std::string list(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
    return names.size() > kMost ? text + ", ..." : text;
  }
  const TextTable& table_;
  const ColumnMapping& mapping_;
  const std::string& file_;
};

struct Columns {
  std::optional<std::size_t> time;
  std::vector<std::size_t> taxels;
};

Columns find_columns(const NumberReader& reader, const ColumnMapping& mapping) {
  Columns columns;
  if (!mapping.time.empty()) columns.time = reader.column(mapping.time, "time");
  for (const TaxelColumn& taxel : mapping.taxels)
    columns.taxels.push_back(reader.column(taxel.column, fmt::format("taxel {}", taxel.taxel)));
  return columns;
}

void tell_missing(RealRecording& recording) {
  const TaxelSeries& series = recording.series;
  for (std::size_t k = 0; k < series.values.size(); ++k) {
    const auto missing =
        std::count_if(series.values[k].begin(), series.values[k].end(), [](double value) { return std::isnan(value); });
    if (missing > 0)
      recording.notes.push_back(
          fmt::format("taxel {}: {} of {} values are missing", series.taxel_ids[k], missing, series.time.size()));
  }
  const double limit = kGapIntervals * median_interval(series.time);
  for (std::size_t i = 1; i < series.time.size(); ++i)
    if (series.time[i] - series.time[i - 1] > limit)
      recording.notes.push_back(
          fmt::format("nothing was recorded from {:.6g} s to {:.6g} s", series.time[i - 1], series.time[i]));
}

void add_row(const NumberReader& reader, const ColumnMapping& mapping, const Columns& columns, const CsvRow& row,
             double time, TaxelSeries& series) {
  series.time.push_back(time);
  for (std::size_t k = 0; k < columns.taxels.size(); ++k) {
    const TaxelColumn& taxel = mapping.taxels[k];
    const double value = reader.at(row, columns.taxels[k]);
    series.values[k].push_back(taxel.gain.value_or(mapping.gain) * value + taxel.offset.value_or(mapping.offset));
  }
}

/// Returns the times of the rows [s] without rounding those of a clock, which begin at the first row.
std::vector<double> times_of(const NumberReader& reader, const ColumnMapping& mapping, std::size_t column,
                             const TextTable& table, std::vector<std::string>& notes) {
  std::vector<long double> exact;
  for (const CsvRow& row : table.rows) {
    const long double time = kSecondsOf.at(static_cast<std::size_t>(mapping.time_unit)) * reader.time_at(row, column);
    if (std::isnan(time)) reader.fail(row, column, "the time is missing");
    if (!exact.empty() && time < exact.back())
      reader.fail(row, column,
                  fmt::format("time runs backwards: {:.9g} s after {:.9g} s", static_cast<double>(time),
                              static_cast<double>(exact.back())));
    exact.push_back(time);
  }
  const bool is_clock = !exact.empty() && exact.front() > kLongestRun;
  const long double start = is_clock ? exact.front() : 0;
  if (is_clock)
    notes.push_back(
        fmt::format("times are those of a clock: they count from the first row, {:.9f} s", static_cast<double>(start)));
  std::vector<double> times;
  for (const long double time : exact) times.push_back(static_cast<double>(time - start));
  return times;
}

/// Notes the columns of the table that the mapping does not use.
void note_unused_columns(const NumberReader& reader, const Columns& columns, RealRecording& recording) {
  std::set<std::size_t> used(columns.taxels.begin(), columns.taxels.end());
  if (columns.time) used.insert(*columns.time);
  if (const std::string names = reader.names_without(used); !names.empty())
    recording.notes.push_back("columns that are not read: " + names);
}

}  // namespace

RealRecording parse_real_recording(const std::string& text, const ColumnMapping& mapping, const std::string& file) {
  check_mapping(mapping, file);
  const TextTable table = split_table(text, mapping, file);
  const NumberReader reader(table, mapping, file);
  const Columns columns = find_columns(reader, mapping);
  RealRecording recording;
  recording.notes = table.notes;
  note_unused_columns(reader, columns, recording);
  TaxelSeries& series = recording.series;
  series.unit = mapping.unit;
  for (const TaxelColumn& taxel : mapping.taxels) series.taxel_ids.push_back(taxel.taxel);
  series.values.resize(mapping.taxels.size());
  std::size_t again = 0;
  for (const CsvRow& row : table.rows)
    if (row.fields.size() != table.columns.size())
      throw Error(file, fmt::format("line {}", row.line),
                  fmt::format("has {} columns, not {}", row.fields.size(), table.columns.size()));
  std::vector<double> times;
  if (columns.time) times = times_of(reader, mapping, *columns.time, table, recording.notes);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const double time = columns.time ? times[r] : static_cast<double>(r) / mapping.rate;
    if (columns.time && !series.time.empty() && time == series.time.back() && ++again > 0) continue;
    add_row(reader, mapping, columns, table.rows[r], time, series);
  }
  if (series.time.size() < 2)
    throw Error(file, fmt::format("has {} rows of numbers, at least 2 are needed", series.time.size()));
  if (again > 0)
    recording.notes.push_back(fmt::format("{} rows have the time of the row before and are left out", again));
  tell_missing(recording);
  return recording;
}

RealRecording read_real_recording(const std::string& file, const ColumnMapping& mapping) {
  return parse_real_recording(read_file(file), mapping, file);
}

TableLook look_at_table(const std::string& text, const ColumnMapping& mapping, const std::string& file,
                        std::size_t most_rows) {
  TextTable table = split_table(text, mapping, file);
  TableLook look{std::move(table.columns), {}};
  for (std::size_t r = 0; r < std::min(most_rows, table.rows.size()); ++r)
    look.rows.push_back(std::move(table.rows[r].fields));
  return look;
}

}  // namespace taxel
