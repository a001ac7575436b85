// Tables as text, comma separated (RFC 4180).
#pragma once

#include <string>
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

}  // namespace taxel
