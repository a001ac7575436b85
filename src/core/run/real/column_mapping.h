// What the columns of a recording from a real sensor mean. A plain value; as a file `*.recmap.json`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace taxel {

enum class TimeUnit { s, ms, us, ns };

/// A column is named as the last header line names it, or by its number: "#1" is the first.
struct TaxelColumn {
  int taxel = 0;  ///< id in the layout
  std::string column;
  std::optional<double> gain, offset;  ///< its own, instead of those of all
  bool operator==(const TaxelColumn&) const = default;
};

struct ColumnMapping {
  std::string separator = ",";  ///< one of , ; tab, or a blank: any run of blanks and tabs
  std::string decimal = ".";    ///< or ","
  int header_lines = 1;         ///< before the numbers; empty lines and those that begin with '#' do not count
  std::string time;             ///< column; empty: there is none, rows are 1 / rate apart
  TimeUnit time_unit = TimeUnit::s;
  double rate = 0;                  ///< rows per second, without a column of time
  std::string unit;                 ///< of the values; empty: unknown
  double gain = 1, offset = 0;      ///< value = gain * field + offset
  std::vector<TaxelColumn> taxels;  ///< at least one; each taxel and each column once
  bool operator==(const ColumnMapping&) const = default;
};

/// {"format": "column-mapping", "version": 1, "separator": ",", "decimal": ".", "header_lines": 1, "time": "t",
///  "time_unit": "ms", "rate": 0, "unit": "Pa", "gain": 1, "offset": 0,
///  "taxels": [{"taxel": 3, "column": "p3", "gain": 2}]}
/// Only `format`, `version` and `taxels` must be there.
std::string mapping_to_json(const ColumnMapping& mapping);
/// Throws Error with file and JSON pointer.
ColumnMapping mapping_from_json(const std::string& text, const std::string& file);
ColumnMapping read_mapping(const std::string& file);

/// Throws Error naming `file` and the pointer of what cannot be: no taxels, one twice, no time and no rate, ...
void check_mapping(const ColumnMapping& mapping, const std::string& file);

}  // namespace taxel
