#include "core/run/real/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Replaces each run of blanks and tabs within a line by one tab, and removes those at its ends, for parse_csv().
std::string with_tabs(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool at_begin = out.empty() || out.back() == '\n';
    if (is_blank(c)) {
      if (!at_begin && out.back() != '\t') out += '\t';
      continue;
    }
    if ((c == '\n' || c == '\r') && !out.empty() && out.back() == '\t') out.pop_back();
    out += c;
  }
  return out;
}

}  // namespace

std::optional<double> number_of(const std::string& field, char decimal) {
  std::string text = field;
  if (decimal != '.') {
    if (text.find('.') != std::string::npos) return std::nullopt;
    std::replace(text.begin(), text.end(), decimal, '.');
  }
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [stopped, code] = std::from_chars(begin, end, value);
  if (code != std::errc() || stopped != end || begin == end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_missing(const std::string& field) {
  std::string word = field;
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word.empty() || word == "nan" || word == "na" || word == "n/a" || word == "null" || word == "-";
}

std::optional<std::size_t> numbered_column(const std::string& name) {
  if (!name.starts_with('#')) return std::nullopt;
  std::size_t number = 0;
  const char* end = name.data() + name.size();
  const auto [stopped, code] = std::from_chars(name.data() + 1, end, number);
  if (code != std::errc() || stopped != end || number == 0) return std::nullopt;
  return number - 1;
}

TextTable split_table(const std::string& text, const ColumnMapping& mapping, const std::string& file) {
  const bool blanks = mapping.separator == " ";
  std::vector<CsvRow> rows =
      blanks ? parse_csv(with_tabs(text), file, '\t') : parse_csv(text, file, mapping.separator.front());
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
  return table;
}

}  // namespace taxel
