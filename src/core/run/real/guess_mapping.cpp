// Guesses the mapping of columns from the names and the first rows of a table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/run/real/real_recording.h"
#include "core/run/real/table_text.h"

namespace taxel {
namespace {

constexpr std::size_t kLooked = 50;   // number of rows that are inspected
constexpr double kGuessedRate = 100;  // rows per second, if no column is a time

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Returns the first lines that are not empty.
std::vector<std::string> first_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size() && lines.size() < kLooked;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line.front() != '#') lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

/// Returns the first separator that the last line contains, or a blank if it contains none. The comma is tried last,
/// since it may be a decimal mark.
std::string separator_in(const std::vector<std::string>& lines) {
  if (lines.empty()) return ",";
  for (const char* mark : {";", "\t", ","})
    if (lines.back().find(*mark) != std::string::npos) return mark;
  return lines.back().find(' ') != std::string::npos ? " " : ",";
}

bool all_numbers(const CsvRow& row, char decimal) {
  return std::all_of(row.fields.begin(), row.fields.end(),
                     [&](const std::string& field) { return is_missing(field) || number_of(field, decimal); });
}

/// Returns the number of lines before the first line that has only numbers.
int header_lines(const std::string& text, ColumnMapping mapping) {
  mapping.header_lines = 0;
  const std::vector<CsvRow> rows = split_table(text, mapping, "").rows;
  std::size_t header = 0;
  while (header < rows.size() && !all_numbers(rows[header], mapping.decimal.front())) ++header;
  return header < rows.size() ? static_cast<int>(header) : 1;
}

bool names_time(const std::string& column) {
  const std::string name = lower_case(column);
  return name == "t" || name.starts_with("t ") || name.starts_with("t[") || name.starts_with("t(") ||
         name.starts_with("t_") || name.find("time") != std::string::npos || name.starts_with("secs");
}

/// Returns the unit in the name of the column of times, or guesses it from the interval of the rows.
TimeUnit unit_of_time(const std::string& column, const std::vector<double>& times) {
  const std::string name = lower_case(column);
  const auto ends = [&](const std::string& unit) {
    for (const std::string before : {"[", "(", "_", " ", "/"})
      if (name.ends_with(before + unit) || name.ends_with(before + unit + "]") || name.ends_with(before + unit + ")"))
        return true;
    return false;
  };
  if (ends("ns") || ends("nsec")) return TimeUnit::ns;
  if (ends("us") || ends("usec")) return TimeUnit::us;
  if (ends("ms") || ends("msec")) return TimeUnit::ms;
  if (ends("s") || ends("sec") || ends("secs")) return TimeUnit::s;
  if (times.size() < 2) return TimeUnit::s;
  // Tactile sensors give ten to some thousand readings per second, so an interval of 1 or more is not in seconds.
  const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (interval >= 1e5) return TimeUnit::ns;
  if (interval >= 500) return TimeUnit::us;
  return interval >= 1 ? TimeUnit::ms : TimeUnit::s;
}

/// Returns the whole number at the end of a name, or nothing.
std::optional<int> number_at_end(const std::string& name) {
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  if (begin == name.size() || name.size() - begin > 8 || name.starts_with('#')) return std::nullopt;
  return std::stoi(name.substr(begin));
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

/// Returns the column with the name of a time, or else the first column if its values always ascend.
void guess_time(const TableLook& look, ColumnMapping& mapping) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < look.columns.size() && !found; ++c)
    if (names_time(look.columns[c])) found = c;
  const std::vector<double> first = first_numbers(look, 0, mapping.decimal.front());
  const bool ascends = std::adjacent_find(first.begin(), first.end(), std::greater_equal<>()) == first.end();
  if (!found && first.size() > 2 && ascends && look.columns.size() > 1) found = 0;
  if (found) {
    mapping.time = name_of(look, *found);
    mapping.time_unit = unit_of_time(look.columns[*found], first_numbers(look, *found, mapping.decimal.front()));
  }
  if (found) mapping.rate = 0;
}

void guess_taxels(const TableLook& look, const std::vector<int>& ids, ColumnMapping& mapping) {
  std::vector<std::size_t> rest;
  std::set<int> free(ids.begin(), ids.end());
  for (std::size_t c = 0; c < look.columns.size(); ++c) {
    if (name_of(look, c) == mapping.time || !numbers_in(look, c, mapping.decimal.front())) continue;
    const std::optional<int> id = number_at_end(look.columns[c]);
    if (id && free.erase(*id) > 0)
      mapping.taxels.push_back({*id, name_of(look, c), {}, {}});
    else
      rest.push_back(c);
  }
  if (!mapping.taxels.empty()) return;
  for (std::size_t i = 0; i < std::min(rest.size(), ids.size()); ++i)
    mapping.taxels.push_back({ids[i], name_of(look, rest[i]), {}, {}});
}

}  // namespace

ColumnMapping guess_mapping(const std::string& text, const std::vector<int>& taxel_ids) {
  ColumnMapping mapping;
  mapping.rate = kGuessedRate;
  try {
    const std::vector<std::string> lines = first_lines(text);
    std::string begin;
    for (const std::string& line : lines) begin += line + "\n";
    mapping.separator = separator_in(lines);
    const bool commas = mapping.separator != "," && !lines.empty() && lines.back().find(',') != std::string::npos;
    if (commas) mapping.decimal.front() = ',';
    mapping.header_lines = header_lines(begin, mapping);
    const TableLook look = look_at_table(begin, mapping, "", kLooked);
    guess_time(look, mapping);
    guess_taxels(look, taxel_ids, mapping);
  } catch (const Error&) {  // the error is reported when the table is read
  }
  return mapping;
}

}  // namespace taxel
