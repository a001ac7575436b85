// The meaning of the columns in a recording from a real sensor. A plain value, stored as `*.recmap.json`.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

enum class TimeUnit { s, ms, us, ns };
inline constexpr std::array<std::string_view, 4> kTimeUnitWords{"s", "ms", "us", "ns"};
inline std::string_view to_word(TimeUnit unit) {
  return kTimeUnitWords[static_cast<std::size_t>(unit)];
}

/// The column with the values of one taxel.
struct TaxelColumn {
  int taxel = 0;                       ///< id in the layout
  std::string column;                  ///< name in the last header line, or number: "#1" is the first column
  std::optional<double> gain, offset;  ///< replace the common gain and offset
  bool operator==(const TaxelColumn&) const = default;
};

struct ColumnMapping {
  std::string separator = ",";  ///< one of , ; tab, or a blank, which means any run of blanks and tabs
  std::string decimal = ".";    ///< decimal mark: "." or ","
  int header_lines = 1;         ///< lines before the numbers, without empty lines and lines that begin with '#'
  std::string time;             ///< column of the times; empty if rows are 1 / rate apart
  TimeUnit time_unit = TimeUnit::s;
  double rate = 0;                  ///< rows per second; used if there is no column of times
  std::string unit;                 ///< unit of the values; empty if unknown
  double gain = 1, offset = 0;      ///< value = gain * field + offset
  std::vector<TaxelColumn> taxels;  ///< at least one; no taxel and no column appears twice
  bool operator==(const ColumnMapping&) const = default;
};

/// Returns the mapping as JSON:
/// {"format": "column-mapping", "version": 1, "separator": ",", "decimal": ".", "header_lines": 1, "time": "t",
///  "time_unit": "ms", "rate": 0, "unit": "Pa", "gain": 1, "offset": 0,
///  "taxels": [{"taxel": 3, "column": "p3", "gain": 2}]}
/// Only `format`, `version` and `taxels` are required.
std::string mapping_to_json(const ColumnMapping& mapping);
/// Reads the mapping from JSON. Throws Error with file and JSON pointer.
ColumnMapping mapping_from_json(const std::string& text, const std::string& file);
ColumnMapping read_mapping(const std::string& file);

/// Checks that a mapping is valid. Throws Error naming `file` and the JSON pointer of the first value that is not, such
/// as an empty list of taxels, a taxel listed twice, or neither `time` nor `rate`.
void check_mapping(const ColumnMapping& mapping, const std::string& file);

}  // namespace taxel
