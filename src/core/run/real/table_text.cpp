#include "core/run/real/table_text.h"

#include <fmt/format.h>

#include <charconv>

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

}  // namespace taxel
