#include "core/run/real/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"

namespace taxel {

std::optional<std::size_t> numbered_column(const std::string& name) {
  if (!name.starts_with('#')) return std::nullopt;
  std::size_t number = 0;
  const char* end = name.data() + name.size();
  const auto [stopped, code] = std::from_chars(name.data() + 1, end, number);
  if (code != std::errc() || stopped != end || number == 0) return std::nullopt;
  return number - 1;
}

TextTable split_table(const std::string& text, const ColumnMapping& mapping, const std::string& file) {
  std::vector<CsvRow> rows = split_rows(utf8_text(text), file, mapping.separator.front());
  const auto header = static_cast<std::size_t>(mapping.header_lines);
  if (rows.size() <= header)
    throw Error(file, fmt::format("has {} lines, of which {} are header: no row", rows.size(), header));
  TextTable table;
  if (header > 0) table.columns = rows[header - 1].fields;
  const std::size_t count = header > 0 ? table.columns.size() : rows.front().fields.size();
  table.columns.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    if (table.columns[i].empty()) table.columns[i] = fmt::format("#{}", i + 1);
  table.rows.assign(std::make_move_iterator(rows.begin() + static_cast<std::ptrdiff_t>(header)),
                    std::make_move_iterator(rows.end()));
  reshape_table(table, file);
  return table;
}

namespace {

using Index = std::ptrdiff_t;

/// A word for a part of a second: its name, and the number of its decimals.
struct SecondWord {
  std::string_view word;
  std::size_t decimals;
};
constexpr SecondWord kSecondWords[] = {{"sec", 0}, {"secs", 0}, {"second", 0}, {"seconds", 0}};
constexpr SecondWord kFractionWords[] = {
    {"nsec", 9}, {"nsecs", 9}, {"nanosec", 9},  {"nanosecs", 9},  {"nanosecond", 9},   {"nanoseconds", 9}, {"ns", 9},
    {"usec", 6}, {"usecs", 6}, {"microsec", 6}, {"microsecs", 6}, {"microseconds", 6}, {"us", 6}};
constexpr std::array<std::string_view, 9> kTaxelWords{"taxel", "taxel_id", "id",      "sensor",   "sensor_id",
                                                      "cell",  "channel",  "taxelid", "electrode"};
constexpr std::array<std::string_view, 6> kValueWords{"value", "reading", "pressure", "force", "raw", "data"};

template <class Words>
bool is_one_of(const Words& words, const std::string& name) {
  return std::find(words.begin(), words.end(), name) != words.end();
}

/// Returns the part of a name before the word at its end: "header.stamp" for "header.stamp.sec". Returns nothing if the
/// name does not end in one of the words.
template <class Words>
std::optional<std::string> stem_before(const std::string& name, const Words& words, std::size_t& decimals) {
  const std::string lower = lower_case(name);
  for (const SecondWord& word : words) {
    if (!lower.ends_with(word.word)) continue;
    const std::size_t begin = lower.size() - word.word.size();
    if (begin > 0 && std::string_view("._/ ").find(lower[begin - 1]) == std::string_view::npos) continue;
    decimals = word.decimals;
    return name.substr(0, begin == 0 ? 0 : begin - 1);
  }
  return std::nullopt;
}

bool has_width(const TextTable& table, const CsvRow& row) {
  return row.fields.size() == table.columns.size();
}

bool is_digits(const std::string& field) {
  return !field.empty() && field.find_first_not_of("0123456789") == std::string::npos;
}

/// Joins whole seconds and a fraction of them as a decimal number. Other fields are joined as they are, and are
/// reported when they are read as a number.
std::string joined_seconds(const std::string& whole, std::string fraction, std::size_t decimals) {
  if (whole.empty() || fraction.empty()) return "";
  if (is_digits(fraction) && fraction.size() < decimals) fraction.insert(0, decimals - fraction.size(), '0');
  const bool is_part = is_digits(fraction) && fraction.size() == decimals;
  return is_part ? whole + "." + fraction : whole + " and " + fraction;
}

/// Joins the two columns of a stamp, if there are two.
void join_stamps(TextTable& table) {
  std::vector<std::string>& names = table.columns;
  for (std::size_t fraction = 0; fraction < names.size(); ++fraction) {
    std::size_t decimals = 0, none = 0;
    const std::optional<std::string> stem = stem_before(names[fraction], kFractionWords, decimals);
    if (!stem) continue;
    const auto is_whole = [&](const std::string& name) { return stem_before(name, kSecondWords, none) == stem; };
    const auto found = std::find_if(names.begin(), names.end(), is_whole);
    if (found == names.end()) continue;
    const auto whole = static_cast<std::size_t>(found - names.begin());
    for (CsvRow& row : table.rows) {
      if (!has_width(table, row)) continue;
      row.fields[whole] = joined_seconds(row.fields[whole], row.fields[fraction], decimals);
      row.fields.erase(row.fields.begin() + static_cast<Index>(fraction));
    }
    const std::string joined = (stem->empty() ? "stamp" : *stem) + " [s]";
    table.notes.push_back(
        fmt::format("columns \"{}\" and \"{}\" are the time \"{}\"", names[whole], names[fraction], joined));
    names[whole] = joined;
    names.erase(names.begin() + static_cast<Index>(fraction));
    return;
  }
}

/// Returns the first field of a column that is not missing, or an empty text.
std::string first_field(const TextTable& table, std::size_t column) {
  for (const CsvRow& row : table.rows)
    if (has_width(table, row) && !is_missing(row.fields[column])) return row.fields[column];
  return "";
}

/// Replaces times of ISO 8601 by seconds.
void read_iso_times(TextTable& table) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!seconds_of_iso_time(first_field(table, c))) continue;
    for (CsvRow& row : table.rows)
      if (has_width(table, row))
        if (const std::optional<std::string> seconds = seconds_of_iso_time(row.fields[c])) row.fields[c] = *seconds;
    if (column_head(table.columns[c]).unit.empty()) table.columns[c] += " [s]";
  }
}

/// Replaces a column of lists by a column for each item. Returns the number of columns in its place.
std::size_t expand_lists(TextTable& table, std::size_t column, const std::string& file) {
  const std::optional<std::vector<std::string>> first = list_of(first_field(table, column));
  if (!first) return 1;
  const std::string name = table.columns[column];
  const std::size_t width = first->size();
  for (CsvRow& row : table.rows) {
    if (!has_width(table, row)) continue;
    std::vector<std::string> items(width);
    if (!is_missing(row.fields[column])) {
      const std::optional<std::vector<std::string>> list = list_of(row.fields[column]);
      if (!list || list->size() != width)
        throw Error(file, fmt::format("line {}, column \"{}\"", row.line, name),
                    fmt::format("must be a list of {} numbers as in the first row, is \"{}\"", width,
                                row.fields[column].substr(0, 40)));
      items = *list;
    }
    const auto at = row.fields.erase(row.fields.begin() + static_cast<Index>(column));
    row.fields.insert(at, items.begin(), items.end());
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < width; ++i) names.push_back(fmt::format("{}[{}]", name, i));
  const auto at = table.columns.erase(table.columns.begin() + static_cast<Index>(column));
  table.columns.insert(at, names.begin(), names.end());
  return width;
}

/// The columns of a table that has one value in each row.
struct LongColumns {
  std::size_t time = 0, taxel = 0, value = 0;
};

/// Returns the only column whose name fulfils a condition, or nothing.
template <class Condition>
std::optional<std::size_t> only_column(const TextTable& table, const Condition& condition) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!condition(table.columns[c])) continue;
    if (found) return std::nullopt;
    found = c;
  }
  return found;
}

std::optional<LongColumns> long_columns(const TextTable& table) {
  const auto named = [](const auto& words) {
    return [&words](const std::string& name) { return is_one_of(words, lower_case(column_head(name).name)); };
  };
  const std::optional<std::size_t> time = only_column(table, names_time),
                                   taxel = only_column(table, named(kTaxelWords)),
                                   value = only_column(table, named(kValueWords));
  if (!time || !taxel || !value || *time == *taxel || *time == *value) return std::nullopt;
  return LongColumns{*time, *taxel, *value};
}

/// Gives each taxel of a table with one value in each row a column, and each time a row.
void widen(TextTable& table, const std::string& file) {
  constexpr std::size_t kMaxFields = 100'000'000;
  const std::optional<LongColumns> at = long_columns(table);
  if (!at) return;
  TextTable wide{{table.columns[at->time]}, {}, std::move(table.notes)};
  const std::string unit = column_head(table.columns[at->value]).unit;
  std::map<std::string, std::size_t> column_of;  // by taxel
  for (const CsvRow& row : table.rows) {
    if (!has_width(table, row)) continue;
    const std::string& taxel = row.fields[at->taxel];
    if (!column_of.try_emplace(taxel, wide.columns.size()).second) continue;
    wide.columns.push_back((is_digits(taxel) ? "taxel_" + taxel : taxel) + (unit.empty() ? "" : " [" + unit + "]"));
  }
  for (const CsvRow& row : table.rows) {
    if (!has_width(table, row))
      throw Error(file, fmt::format("line {}", row.line),
                  fmt::format("has {} columns, not {}", row.fields.size(), table.columns.size()));
    const std::string& time = row.fields[at->time];
    if (wide.rows.empty() || wide.rows.back().fields.front() != time) {
      if (wide.rows.size() * wide.columns.size() > kMaxFields)
        throw Error(file, fmt::format("has too many times and taxels: more than {} values", kMaxFields));
      wide.rows.push_back({row.line, std::vector<std::string>(wide.columns.size())});
      wide.rows.back().fields.front() = time;
    }
    std::string& field = wide.rows.back().fields[column_of.at(row.fields[at->taxel])];
    if (!field.empty())
      throw Error(file, fmt::format("line {}", row.line),
                  fmt::format("taxel \"{}\" has a second value at the time {}", row.fields[at->taxel], time));
    field = row.fields[at->value];
  }
  wide.notes.push_back(fmt::format("each row has one value, \"{}\", of the taxel in column \"{}\"",
                                   table.columns[at->value], table.columns[at->taxel]));
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (c != at->time && c != at->taxel && c != at->value)
      wide.notes.push_back(fmt::format("column \"{}\" is not read", table.columns[c]));
  table = std::move(wide);
}

}  // namespace

bool names_time(const std::string& column) {
  const std::string name = lower_case(column_head(column).name);
  return name == "t" || name.find("time") != std::string::npos || name.find("stamp") != std::string::npos ||
         name == "secs" || name == "seconds";
}

void reshape_table(TextTable& table, const std::string& file) {
  join_stamps(table);
  read_iso_times(table);
  for (std::size_t c = 0; c < table.columns.size();) c += expand_lists(table, c, file);
  widen(table, file);
}

namespace {

constexpr std::array kSecondsOf{1.0L, 1e-3L, 1e-6L, 1e-9L};  // in the order of TimeUnit
constexpr double kLongestRun = 1e8;                          // three years: later times are those of a clock [s]

std::string joined_names(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > kMost ? text + ", ..." : text;
}

}  // namespace

std::size_t NumberReader::column(const std::string& name, const std::string& pointer) const {
  const std::vector<std::string>& names = table_.columns;
  if (const auto number = numbered_column(name); number && *number < names.size()) return *number;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(file_, pointer, fmt::format("there is no column \"{}\"; there are {}", name, joined_names(names)));
  if (std::find(found + 1, names.end(), name) != names.end())
    throw Error(
        file_, pointer,
        fmt::format("several columns are named \"{}\": give its number, as #{}", name, found - names.begin() + 1));
  return static_cast<std::size_t>(found - names.begin());
}

void NumberReader::fail(const CsvRow& row, std::size_t column, const std::string& why) const {
  throw Error(file_, fmt::format("line {}, column \"{}\"", row.line, table_.columns[column]), why);
}

void NumberReader::check_widths() const {
  for (const CsvRow& row : table_.rows)
    if (row.fields.size() != table_.columns.size())
      throw Error(file_, fmt::format("line {}", row.line),
                  fmt::format("has {} columns, not {}", row.fields.size(), table_.columns.size()));
}

double NumberReader::at(const CsvRow& row, std::size_t column) const {
  const std::string& field = row.fields[column];
  if (is_missing(field)) return std::numeric_limits<double>::quiet_NaN();
  const std::optional<double> number = number_of(field, mapping_.decimal.front());
  if (!number) fail(row, column, fmt::format("is no number: \"{}\"", field));
  return *number;
}

/// Returns the number in a field of times with more digits than a double has: stamps count from 1970.
long double NumberReader::time_at(const CsvRow& row, std::size_t column) const {
  const double rounded = at(row, column);
  std::string text = row.fields[column];
  std::replace(text.begin(), text.end(), ',', '.');
  long double exact = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exact);
  return error == std::errc() && !std::isnan(rounded) ? exact : rounded;
}

std::vector<double> NumberReader::times(std::size_t column, std::vector<std::string>& notes) const {
  std::vector<long double> exact;
  for (const CsvRow& row : table_.rows) {
    const long double time = kSecondsOf.at(static_cast<std::size_t>(mapping_.time_unit)) * time_at(row, column);
    if (std::isnan(time)) fail(row, column, "the time is missing");
    if (!exact.empty() && time < exact.back())
      fail(row, column,
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

std::string NumberReader::names_without(const std::set<std::size_t>& used) const {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < table_.columns.size(); ++c)
    if (!used.contains(c)) names.push_back(table_.columns[c]);
  return joined_names(names);
}

}  // namespace taxel
