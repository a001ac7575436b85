// Rows of comma separated values, and guesses of the form of other tables.

#include "core/base/text/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text/expression.h"

namespace taxel {
namespace {

/// Splits a text into rows and fields, character by character.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file, char separator)
      : text_(text), file_(file), separator_(separator) {
    const std::string mark = "\xEF\xBB\xBF";  // some programs write this mark before UTF-8
    if (text.starts_with(mark)) at_ = mark.size();
  }

  std::vector<CsvRow> rows() {
    std::vector<CsvRow> rows;
    while (at_ < text_.size()) {
      CsvRow row = next_row();
      const bool empty = row.fields.size() == 1 && row.fields[0].empty();
      if (!empty) rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw Error(file_, fmt::format("line {}", line), message);
  }
  [[nodiscard]] bool at_end_of_line() const { return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
  [[nodiscard]] static bool blank(char c) { return c == ' ' || c == '\t'; }
  [[nodiscard]] bool skips(char c) const { return blank(c) && c != separator_; }

  CsvRow next_row() {
    CsvRow row{line_, {}};
    if (text_[at_] == '#') {
      while (!at_end_of_line()) ++at_;
      row.fields.emplace_back();
    } else {
      row.fields.push_back(next_field());
      while (!at_end_of_line()) {
        ++at_;  // the separator
        row.fields.push_back(next_field());
      }
    }
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
    return row;
  }

  [[nodiscard]] bool separates(char c) {
    if (separator_ == '\0' && (c == ',' || c == ';' || c == '\t')) separator_ = c;
    return c == separator_;
  }

  std::string next_field() {
    while (at_ < text_.size() && skips(text_[at_]) && !(separator_ == '\0' && text_[at_] == '\t')) ++at_;
    if (at_ < text_.size() && text_[at_] == '"') return quoted_field();
    std::string field;
    while (!at_end_of_line() && !separates(text_[at_])) {
      if (text_[at_] == '"') fail(line_, "a quote is inside of a field");
      field += text_[at_++];
    }
    while (!field.empty() && blank(field.back())) field.pop_back();
    return field;
  }

  std::string quoted_field() {
    const int begin = line_;
    std::string field;
    for (++at_;; ++at_) {
      if (at_ >= text_.size()) fail(begin, "a quote is not closed");
      if (text_[at_] == '"') {
        if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') break;
        ++at_;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    ++at_;
    while (at_ < text_.size() && skips(text_[at_]) && !(separator_ == '\0' && text_[at_] == '\t')) ++at_;
    if (!at_end_of_line() && !separates(text_[at_])) fail(line_, "a quoted field goes on behind its quote");
    return field;
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  char separator_;  ///< '\0' if not known yet
};

}  // namespace

std::string csv_field(const std::string& text) {
  const bool trimmed = text.starts_with(' ') || text.ends_with(' ') || text.starts_with('#');
  if (!trimmed && text.find_first_of(",\"\r\n\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::vector<CsvRow> parse_csv(const std::string& text, const std::string& file, char separator) {
  return Reader(text, file, separator).rows();
}

namespace {

constexpr std::size_t kInspectedLines = 50;

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Replaces each run of blanks and tabs within a line by one tab, and removes those at its ends, for parse_csv().
/// Blanks in quotes and brackets remain.
std::string with_tabs(const std::string& text) {
  std::string out;
  bool is_quoted = false;
  int depth = 0;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == '\n') depth = 0;
    if (c == '[') ++depth;
    if (c == ']') depth = std::max(0, depth - 1);
    const bool at_begin = out.empty() || out.back() == '\n';
    if (is_blank(c) && !is_quoted && depth == 0) {
      if (!at_begin && out.back() != '\t') out += '\t';
      continue;
    }
    if ((c == '\n' || c == '\r') && !out.empty() && out.back() == '\t') out.pop_back();
    out += c;
  }
  return out;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
  if (code < 0x80U) return byte(code);
  if (code < 0x800U) {
    byte(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000U) {
      byte(0xE0U | code >> 12U);
    } else {
      byte(0xF0U | code >> 18U);
      byte(0x80U | (code >> 12U & 0x3FU));
    }
    byte(0x80U | (code >> 6U & 0x3FU));
  }
  byte(0x80U | (code & 0x3FU));
}

std::string from_utf16(const std::string& bytes, bool is_big_endian) {
  std::string text;
  std::uint32_t high = 0;  // first half of a code point beyond 16 bits
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    const std::uint32_t unit = is_big_endian ? first << 8U | second : second << 8U | first;
    if (unit >= 0xD800U && unit < 0xDC00U) {
      high = unit;
    } else if (unit >= 0xDC00U && unit < 0xE000U && high != 0) {
      append_utf8(text, 0x10000U + ((high - 0xD800U) << 10U) + (unit - 0xDC00U));
      high = 0;
    } else if (unit != 0xFEFFU) {
      append_utf8(text, unit);
    }
  }
  return text;
}

/// Returns the first lines that are neither empty nor comments.
std::vector<std::string> first_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size() && lines.size() < kInspectedLines;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line.front() != '#') lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

/// Returns the line without its texts in quotes and its lists.
std::string outside_of_cells(const std::string& line) {
  std::string out;
  bool is_quoted = false;
  int depth = 0;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == '[' && !is_quoted) ++depth;
    if (!is_quoted && depth == 0) out += c;
    if (c == ']' && !is_quoted) depth = std::max(0, depth - 1);
  }
  return out;
}

/// Returns the first separator that a line contains, or 0. The comma is tried last, since it may be a decimal mark.
char separator_in(const std::string& line) {
  const std::string cells = outside_of_cells(line);
  for (const char mark : {';', '\t', ','})
    if (cells.find(mark) != std::string::npos) return mark;
  return cells.find(' ') != std::string::npos ? ' ' : '\0';
}

bool is_value(const std::string& field, char decimal) {
  return is_missing(field) || number_of(field, decimal) || list_of(field) || seconds_of_iso_time(field);
}

/// Returns the number of lines before the first row that has only values.
int count_header_lines(const std::vector<CsvRow>& rows, char decimal) {
  std::size_t header = 0;
  const auto has_values = [&](const CsvRow& row) {
    return std::all_of(row.fields.begin(), row.fields.end(),
                       [&](const std::string& field) { return is_value(field, decimal); });
  };
  while (header < rows.size() && !has_values(rows[header])) ++header;
  return header < rows.size() ? static_cast<int>(header) : 1;
}

/// Returns true if a field of the row is a number with a comma as its decimal mark.
bool has_decimal_comma(const CsvRow& row) {
  return std::any_of(row.fields.begin(), row.fields.end(), [](const std::string& field) {
    return field.find(',') != std::string::npos && number_of(field, ',');
  });
}

bool is_known_unit(std::string_view word) {
  return unit_named(word).has_value();
}

/// Reads whole numbers and marks from a text, one after the other.
class DigitReader {
 public:
  explicit DigitReader(std::string_view text) : text_(text) {}

  /// Reads a number of exactly `digits` digits. Without one, the reader fails.
  int number(std::size_t digits) {
    int value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
      if (text_.empty() || text_.front() < '0' || text_.front() > '9') {
        is_valid_ = false;
        return 0;
      }
      value = 10 * value + (text_.front() - '0');
      text_.remove_prefix(1);
    }
    return value;
  }
  /// Passes over one of the marks, and returns the mark. Returns 0 if there is none.
  char pass(std::string_view marks) {
    if (text_.empty() || marks.find(text_.front()) == std::string_view::npos) return '\0';
    const char mark = text_.front();
    text_.remove_prefix(1);
    return mark;
  }
  void expect(std::string_view marks) { is_valid_ = pass(marks) != '\0' && is_valid_; }
  /// Reads any number of digits.
  std::string digits() {
    const std::size_t end = std::min(text_.find_first_not_of("0123456789"), text_.size());
    std::string read(text_.substr(0, end));
    text_.remove_prefix(end);
    return read;
  }
  [[nodiscard]] bool is_at_end() const { return is_valid_ && text_.empty(); }

 private:
  std::string_view text_;
  bool is_valid_ = true;
};

}  // namespace

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string utf8_text(const std::string& bytes) {
  const std::string_view view(bytes);
  if (view.starts_with("\xFF\xFE")) return from_utf16(bytes, false);
  if (view.starts_with("\xFE\xFF")) return from_utf16(bytes, true);
  if (view.starts_with("\xEF\xBB\xBF")) return bytes.substr(3);
  if (bytes.size() > 3 && bytes[0] != '\0' && bytes[1] == '\0' && bytes[3] == '\0') return from_utf16(bytes, false);
  if (bytes.size() > 3 && bytes[0] == '\0' && bytes[1] != '\0' && bytes[2] == '\0') return from_utf16(bytes, true);
  return bytes;
}

TableForm guess_table_form(const std::string& text) {
  TableForm form;
  const std::vector<std::string> lines = first_lines(text);
  if (lines.empty()) return form;
  const char last = separator_in(lines.back()), first = separator_in(lines.front());
  form.separator = last != '\0' ? last : first != '\0' ? first : ',';
  std::string begin;
  for (const std::string& line : lines) begin += line + "\n";
  try {
    const std::vector<CsvRow> rows = split_rows(begin, "", form.separator);
    if (form.separator != ',' && !rows.empty() && has_decimal_comma(rows.back())) form.decimal = ',';
    form.header_lines = count_header_lines(rows, form.decimal);
  } catch (const Error&) {  // the error is reported when the table is read
  }
  return form;
}

std::vector<CsvRow> split_rows(const std::string& text, const std::string& file, char separator) {
  return separator == ' ' ? parse_csv(with_tabs(text), file, '\t') : parse_csv(text, file, separator);
}

ColumnHead column_head(const std::string& text) {
  const auto trimmed = [](std::string word) {
    while (!word.empty() && (is_blank(word.back()) || word.back() == '_')) word.pop_back();
    return word;
  };
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    const std::size_t begin = text.rfind(open);
    if (begin == std::string::npos || begin == 0 || !text.ends_with(close)) continue;
    const std::string unit = text.substr(begin + 1, text.size() - begin - 2);
    const bool is_number = !unit.empty() && unit.find_first_not_of("0123456789") == std::string::npos;
    if (!unit.empty() && !is_number) return {trimmed(text.substr(0, begin)), unit};
  }
  const std::size_t mark = text.find_last_of("_ /");
  if (mark == std::string::npos || mark == 0 || !is_known_unit(text.substr(mark + 1))) return {text};
  return {trimmed(text.substr(0, mark)), text.substr(mark + 1)};
}

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
  const std::string word = lower_case(field);
  return word.empty() || word == "nan" || word == "na" || word == "n/a" || word == "null" || word == "-";
}

std::optional<std::vector<std::string>> list_of(const std::string& field) {
  if (field.size() < 2 || !field.starts_with('[') || !field.ends_with(']')) return std::nullopt;
  std::vector<std::string> items;
  const std::string_view inner = std::string_view(field).substr(1, field.size() - 2);
  constexpr std::string_view kMarks = ",; \t\r\n[]";
  for (std::size_t at = inner.find_first_not_of(kMarks); at != std::string_view::npos;) {
    const std::size_t end = std::min(inner.find_first_of(kMarks, at), inner.size());
    items.emplace_back(inner.substr(at, end - at));
    at = inner.find_first_not_of(kMarks, end);
  }
  return items;
}

std::optional<std::string> seconds_of_iso_time(const std::string& field) {
  DigitReader in(field);
  const int year = in.number(4);
  in.expect("-/");
  const int month = in.number(2);
  in.expect("-/");
  const int day = in.number(2);
  in.expect("T t");
  const int hour = in.number(2);
  in.expect(":");
  const int minute = in.number(2);
  in.expect(":");
  const int second = in.number(2);
  const std::string fraction = in.pass(".,") != '\0' ? in.digits() : "";
  long zone = 0;
  if (const char sign = in.pass("Zz+-"); sign == '+' || sign == '-') {
    zone = 3600L * in.number(2);
    in.pass(":");
    zone = (zone + 60L * in.number(2)) * (sign == '-' ? -1 : 1);
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!in.is_at_end() || !date.ok() || hour > 24 || minute > 59 || second > 60) return std::nullopt;
  const long days = std::chrono::sys_days(date).time_since_epoch().count();
  const long whole = 86400L * days + 3600L * hour + 60L * minute + second - zone;
  return whole < 0 ? std::nullopt
                   : std::optional(fraction.empty() ? fmt::format("{}", whole) : fmt::format("{}.{}", whole, fraction));
}

}  // namespace taxel
