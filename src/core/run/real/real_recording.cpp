#include "core/run/real/real_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/run/real/table_text.h"

namespace taxel {

double median_interval(const std::vector<double>& time) {
  if (time.size() < 2) return 0;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time.size(); ++i) intervals.push_back(time[i] - time[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

Interpolated::Interpolated(const TaxelSeries& series, std::size_t taxel)
    : gap_(kGapIntervals * median_interval(series.time)) {
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (std::isnan(series.values[taxel][i])) continue;
    time_.push_back(series.time[i]);
    value_.push_back(series.values[taxel][i]);
  }
}

double Interpolated::at(double time) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  if (time_.empty() || time < time_.front() || time > time_.back()) return kNothing;
  const auto next = static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), time) - time_.begin());
  if (time_[next] == time) return value_[next];
  const double width = time_[next] - time_[next - 1];
  if (width > gap_) return kNothing;
  const double part = (time - time_[next - 1]) / width;
  return (1 - part) * value_[next - 1] + part * value_[next];
}

TaxelSeries series_of(const Recording& recording, std::size_t sensor) {
  const RecordedSensor& of = recording.sensors[sensor];
  TaxelSeries series{of.reading_unit, {}, of.taxel_ids, {}};
  series.values.resize(of.taxel_ids.size());
  for (const RecordedRow& row : recording.rows) {
    if (!series.time.empty() && row.time <= series.time.back()) continue;
    series.time.push_back(row.time);
    for (std::size_t k = 0; k < series.values.size(); ++k) series.values[k].push_back(row.sensors[sensor].readings[k]);
  }
  return series;
}

double range_of(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const double value : values)
    if (!std::isnan(value)) least = std::min(least, value), largest = std::max(largest, value);
  return largest >= least ? largest - least : 0;
}

namespace {

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
  reader.check_widths();
  std::vector<double> times;
  if (columns.time) times = reader.times(*columns.time, recording.notes);
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

TableLook look_at_table(const std::string& text, const ColumnMapping& mapping, const std::string& file,
                        std::size_t most_rows) {
  TextTable table = split_table(text, mapping, file);
  TableLook look{std::move(table.columns), {}};
  for (std::size_t r = 0; r < std::min(most_rows, table.rows.size()); ++r)
    look.rows.push_back(std::move(table.rows[r].fields));
  return look;
}

namespace {

constexpr std::size_t kLooked = 50;  // number of rows that are inspected

/// Returns the unit in the name of the column of times, or guesses it from the interval of the rows.
TimeUnit unit_of_time(const std::string& column, const std::vector<double>& times) {
  const std::string unit = lower_case(column_head(column).unit), name = lower_case(column);
  const auto is = [&](const std::string& word) {
    return unit == word || unit == word + "ec" || unit == word + "ecs" || name.ends_with("_" + word + "ec") ||
           name.ends_with("_" + word + "ecs");
  };
  if (is("ns")) return TimeUnit::ns;
  if (is("us") || unit == "\u00b5s") return TimeUnit::us;
  if (is("ms")) return TimeUnit::ms;
  if (is("s")) return TimeUnit::s;
  if (times.size() < 2) return TimeUnit::s;
  // Tactile sensors give ten to some thousand readings per second, so an interval of 1 or more is not in seconds.
  const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (interval >= 1e5) return TimeUnit::ns;
  if (interval >= 500) return TimeUnit::us;
  return interval >= 1 ? TimeUnit::ms : TimeUnit::s;
}

/// A name with "#" in the place of each whole number, and these numbers.
struct NumberedName {
  std::string pattern;
  std::vector<int> numbers;
};

NumberedName numbered_name(const std::string& column) {
  constexpr std::size_t kMaxDigits = 8;
  const std::string name = lower_case(column_head(column).name);
  NumberedName split;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t end = std::min(name.find_first_not_of("0123456789", at), name.size());
    if (end == at || end - at > kMaxDigits) {
      split.pattern += name.substr(at, std::max<std::size_t>(1, end - at));
      at = std::max(at + 1, end);
      continue;
    }
    split.numbers.push_back(std::stoi(name.substr(at, end - at)));
    split.pattern += '#';
    at = end;
  }
  return split;
}

/// Returns the whole number at the end of a name, also in brackets, or nothing.
std::optional<int> number_at_end(const std::string& name) {
  const NumberedName split = numbered_name(name);
  std::string pattern = split.pattern;
  while (pattern.ends_with(']') || pattern.ends_with(')')) pattern.pop_back();
  if (name.starts_with('#') || split.numbers.empty() || !pattern.ends_with('#')) return std::nullopt;
  return split.numbers.back();
}

/// Returns true if most fields of the column are numbers. A field that is not is reported when the table is read.
bool numbers_in(const TableLook& look, std::size_t column, char decimal) {
  const auto numbers = std::count_if(look.rows.begin(), look.rows.end(), [&](const std::vector<std::string>& row) {
    return column < row.size() && (is_missing(row[column]) || number_of(row[column], decimal));
  });
  return 2 * numbers > static_cast<std::ptrdiff_t>(look.rows.size());
}

/// Returns the name by which a mapping refers to a column: its number if the name is empty or not unique.
std::string name_of(const TableLook& look, std::size_t column) {
  const bool single = std::count(look.columns.begin(), look.columns.end(), look.columns[column]) == 1;
  return single ? look.columns[column] : fmt::format("#{}", column + 1);
}

std::vector<double> first_numbers(const TableLook& look, std::size_t column, char decimal) {
  std::vector<double> numbers;
  for (const std::vector<std::string>& row : look.rows)
    if (column < row.size())
      if (const auto number = number_of(row[column], decimal)) numbers.push_back(*number);
  return numbers;
}

/// Returns true if the numbers count rows: each is the previous one plus 1. Their rate is not known.
bool count_rows(const std::vector<double>& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(), [](double a, double b) { return b - a != 1; }) ==
         numbers.end();
}

/// Returns the column with the name of a time, or else the first column if its values always ascend and count no rows.
void guess_time(const TableLook& look, ColumnMapping& mapping) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < look.columns.size() && !found; ++c)
    if (names_time(look.columns[c])) found = c;
  const std::vector<double> first = first_numbers(look, 0, mapping.decimal.front());
  const bool ascends = std::adjacent_find(first.begin(), first.end(), std::greater_equal<>()) == first.end();
  if (!found && first.size() > 2 && ascends && !count_rows(first) && look.columns.size() > 1) found = 0;
  if (!found) return;
  mapping.time = name_of(look, *found);
  mapping.time_unit = unit_of_time(look.columns[*found], first_numbers(look, *found, mapping.decimal.front()));
}

using ColumnList = std::vector<std::size_t>;
using TaxelPairs = std::vector<std::pair<int, std::size_t>>;  // taxel and column

/// Returns the pairs of a grid whose columns are named by row and column, such as r0c0: the ids in ascending order are
/// those of the grid row by row.
TaxelPairs pairs_of_grid(const TableLook& look, const ColumnList& columns, const std::vector<int>& ids) {
  std::map<std::pair<int, int>, std::size_t> cells;
  std::set<int> rows, places;
  std::string pattern;
  for (const std::size_t c : columns) {
    const NumberedName name = numbered_name(look.columns[c]);
    if (name.numbers.size() != 2 || (!pattern.empty() && name.pattern != pattern)) return {};
    pattern = name.pattern;
    cells[{name.numbers[0], name.numbers[1]}] = c;
    rows.insert(name.numbers[0]);
    places.insert(name.numbers[1]);
  }
  const bool is_grid = rows.size() > 1 && cells.size() == columns.size() && cells.size() == rows.size() * places.size();
  if (!is_grid || cells.size() != ids.size()) return {};
  std::vector<int> sorted = ids;
  std::sort(sorted.begin(), sorted.end());
  TaxelPairs pairs;
  for (const auto& [cell, column] : cells) pairs.emplace_back(sorted[pairs.size()], column);
  return pairs;
}

/// Returns the pairs of columns that end in the id of a taxel. If the numbers of all columns that differ only in their
/// number are all ids plus 1 or minus 1, they count from 1 where the ids count from 0, or the other way round.
TaxelPairs pairs_of_numbers(const TableLook& look, const ColumnList& columns, const std::vector<int>& ids) {
  const std::set<int> wanted(ids.begin(), ids.end());
  std::map<std::string, std::map<int, std::size_t>> families;  // column by number, by the rest of the name
  for (const std::size_t c : columns)
    if (const std::optional<int> number = number_at_end(look.columns[c]))
      families[numbered_name(look.columns[c]).pattern].try_emplace(*number, c);
  for (const int shift : {0, -1, 1}) {
    for (const auto& [pattern, family] : families) {
      TaxelPairs pairs;
      for (const auto& [number, column] : family)
        if (wanted.contains(number + shift)) pairs.emplace_back(number + shift, column);
      if (pairs.size() == family.size() && pairs.size() == wanted.size()) return pairs;
    }
  }
  std::set<int> free = wanted;
  TaxelPairs pairs;
  for (const std::size_t c : columns)
    if (const std::optional<int> number = number_at_end(look.columns[c]); number && free.erase(*number) > 0)
      pairs.emplace_back(*number, c);
  return pairs;
}

void guess_taxels(const TableLook& look, const std::vector<int>& ids, ColumnMapping& mapping) {
  ColumnList columns;
  for (std::size_t c = 0; c < look.columns.size(); ++c)
    if (name_of(look, c) != mapping.time && numbers_in(look, c, mapping.decimal.front())) columns.push_back(c);
  TaxelPairs pairs = pairs_of_grid(look, columns, ids);
  if (pairs.empty()) pairs = pairs_of_numbers(look, columns, ids);
  const bool has_names = mapping.header_lines > 0;
  if (pairs.empty() && (!has_names || columns.size() == ids.size()))
    for (std::size_t i = 0; i < std::min(columns.size(), ids.size()); ++i) pairs.emplace_back(ids[i], columns[i]);
  std::set<std::string> units;
  for (const auto& [taxel, column] : pairs) {
    mapping.taxels.push_back({taxel, name_of(look, column), {}, {}});
    units.insert(column_head(look.columns[column]).unit);
  }
  if (units.size() == 1) mapping.unit = *units.begin();
}

/// Returns the look of a table, or that of its first lines if a later line is not valid, which is reported when the
/// table is read.
TableLook look_at_all_or_begin(const std::string& text, const ColumnMapping& mapping) {
  try {
    return look_at_table(text, mapping, "", kLooked);
  } catch (const Error&) {
    std::size_t end = 0;
    for (std::size_t line = 0; line < kLooked && end < text.size(); ++line)
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    return look_at_table(text.substr(0, end), mapping, "", kLooked);
  }
}

}  // namespace

ColumnMapping guess_mapping(const std::string& table, const std::vector<int>& taxel_ids) {
  ColumnMapping mapping;
  try {
    const std::string text = utf8_text(table);
    const TableForm form = guess_table_form(text);
    mapping.separator = std::string(1, form.separator);
    mapping.decimal = std::string(1, form.decimal);
    mapping.header_lines = form.header_lines;
    const TableLook look = look_at_all_or_begin(text, mapping);
    guess_time(look, mapping);
    guess_taxels(look, taxel_ids, mapping);
  } catch (const Error&) {  // the error is reported when the table is read
  }
  return mapping;
}

std::vector<int> taxels_without_column(const ColumnMapping& mapping, std::vector<int> taxel_ids) {
  std::erase_if(taxel_ids, [&](int id) {
    return std::any_of(mapping.taxels.begin(), mapping.taxels.end(),
                       [&](const TaxelColumn& one) { return one.taxel == id; });
  });
  return taxel_ids;
}

}  // namespace taxel
