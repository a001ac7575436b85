// Tables as text, comma separated (RFC 4180).
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// A field as CSV wants it: quoted where it holds a comma, a quote, a tab or a line break, or where its ends would be
/// taken for something else.
std::string csv_field(const std::string& text);

/// Rows with the line (from 1) where each begins; quotes are taken off, blanks around fields too unless quoted. Empty
/// lines and those that begin with '#' are left out. The separator is given, or the first of comma, semicolon and tab
/// in the first row, outside of quotes. Throws Error(file, "line N", ...) for a quote that is not closed or stands
/// within a field.
struct CsvRow {
  int line = 0;
  std::vector<std::string> fields;
};
std::vector<CsvRow> parse_csv(const std::string& text, const std::string& file = "", char separator = '\0');

}  // namespace taxel
