// Tables as text, comma separated (RFC 4180), and as programs and spreadsheets write them: encoding, separator, decimal
// mark, header lines, units in the heads of columns, lists and times in cells. Readers of layouts and of recordings use
// these functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

/// Returns a field as CSV requires it: in quotes if it contains a comma, a quote, a tab or a line break, or if a reader
/// would otherwise remove something from its ends.
std::string csv_field(const std::string& text);

/// One row with the number of its first line (from 1). Quotes are removed from fields, and so are blanks around fields
/// unless they are quoted. Empty lines and lines that begin with '#' are skipped. The separator is given, or is the
/// first comma, semicolon or tab in the first row outside of quotes. Throws Error(file, "line N", ...) for a quote that
/// is not closed or is inside of a field without quotes.
struct CsvRow {
  int line = 0;
  std::vector<std::string> fields;
};
std::vector<CsvRow> parse_csv(const std::string& text, const std::string& file = "", char separator = '\0');

/// Returns a text as UTF-8 without a byte order mark. Bytes in UTF-16 are recognised by their mark, or without a mark
/// by the zero byte of their first letter; other bytes are returned as they are.
std::string utf8_text(const std::string& bytes);

/// The marks of a table, and the number of lines before its numbers.
struct TableForm {
  char separator = ',';  ///< one of , ; tab, or a blank, which means any run of blanks and tabs
  char decimal = '.';
  int header_lines = 1;
};

/// Guesses the form of a table from its first lines. Nothing is thrown.
TableForm guess_table_form(const std::string& text);

/// Splits a text by its separator. Throws Error as parse_csv() does.
std::vector<CsvRow> split_rows(const std::string& text, const std::string& file, char separator);

/// The name of a column and the unit after it: "x [mm]", "x (mm)" and "x_mm" have the name x.
struct ColumnHead {
  std::string name;
  std::string unit = {};  ///< word of the file; empty if there is none
};

/// Splits the head of a column. In brackets any word is a unit; after an underscore or a blank only a known one is.
ColumnHead column_head(const std::string& text);

/// Returns the finite number in a field with this decimal mark, or nothing if the field is not such a number.
std::optional<double> number_of(const std::string& field, char decimal);
/// Returns true if the field is empty or is a word for a missing value, such as "nan".
bool is_missing(const std::string& field);
/// Returns the items of a list in brackets, "[1, 2 3; 4]"; nothing for other fields.
std::optional<std::vector<std::string>> list_of(const std::string& field);
/// Returns the seconds since 1970, as text with all digits, of a time such as "2026-11-29T07:00:00.125+01:00" (ISO
/// 8601; without a zone it is UTC). Returns nothing for other fields.
std::optional<std::string> seconds_of_iso_time(const std::string& field);

/// Returns the text in lower case (ASCII letters).
std::string lower_case(std::string text);

}  // namespace taxel
