// A recording from a real sensor: a table of numbers, read as a ColumnMapping says.
#pragma once

#include <string>
#include <vector>

#include "core/run/real/column_mapping.h"
#include "core/run/real/taxel_series.h"

namespace taxel {

struct RealRecording {
  TaxelSeries series;              ///< in the mapping's order of taxels; time as the table has it
  std::vector<std::string> notes;  ///< what is missing in it, in words
};

/// Fields that hold nothing, "nan", "NA", "null" or "-" are missing values. Rows with the time of the row before are
/// left out. Throws Error(file, "line 7, column \"p3\"", ...) for a field that is no number, a row of another length, a
/// time that is missing or runs backwards, a column that is not there, a table without rows.
RealRecording parse_real_recording(const std::string& text, const ColumnMapping& mapping, const std::string& file);
RealRecording read_real_recording(const std::string& file, const ColumnMapping& mapping);

/// What a table looks like, for a mapping to be made.
struct TableLook {
  std::vector<std::string> columns;            ///< names, or "#1", "#2", ... where no line names them
  std::vector<std::vector<std::string>> rows;  ///< the first ones, as text
};
TableLook look_at_table(const std::string& text, const ColumnMapping& mapping, const std::string& file,
                        std::size_t most_rows);

/// As good a mapping as names and first rows tell: what separates, which lines are no numbers, a column named like a
/// time and its unit (by its name, "t [ms]", else by how far its rows are apart), columns that end in the id of one of
/// the taxels
/// ("taxel_3", "p3"); where none does, the columns that are left, in order. Never throws for what it cannot tell.
ColumnMapping guess_mapping(const std::string& text, const std::vector<int>& taxel_ids);

}  // namespace taxel
