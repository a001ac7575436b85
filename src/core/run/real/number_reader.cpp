#include "core/run/real/number_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace taxel {
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
