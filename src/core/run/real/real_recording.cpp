#include "core/run/real/real_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/real/number_reader.h"

namespace taxel {
namespace {

struct Columns {
  std::optional<std::size_t> time;
  std::vector<std::size_t> taxels;
};

Columns find_columns(const NumberReader& reader, const ColumnMapping& mapping) {
  Columns columns;
  if (!mapping.time.empty()) columns.time = reader.column(mapping.time, "time");
  for (const TaxelColumn& taxel : mapping.taxels)
    columns.taxels.push_back(reader.column(taxel.column, fmt::format("taxel {}", taxel.taxel)));
  return columns;
}

void tell_missing(RealRecording& recording) {
  const TaxelSeries& series = recording.series;
  for (std::size_t k = 0; k < series.values.size(); ++k) {
    const auto missing =
        std::count_if(series.values[k].begin(), series.values[k].end(), [](double value) { return std::isnan(value); });
    if (missing > 0)
      recording.notes.push_back(
          fmt::format("taxel {}: {} of {} values are missing", series.taxel_ids[k], missing, series.time.size()));
  }
  const double limit = kGapIntervals * median_interval(series.time);
  for (std::size_t i = 1; i < series.time.size(); ++i)
    if (series.time[i] - series.time[i - 1] > limit)
      recording.notes.push_back(
          fmt::format("nothing was recorded from {:.6g} s to {:.6g} s", series.time[i - 1], series.time[i]));
}

void add_row(const NumberReader& reader, const ColumnMapping& mapping, const Columns& columns, const CsvRow& row,
             double time, TaxelSeries& series) {
  series.time.push_back(time);
  for (std::size_t k = 0; k < columns.taxels.size(); ++k) {
    const TaxelColumn& taxel = mapping.taxels[k];
    const double value = reader.at(row, columns.taxels[k]);
    series.values[k].push_back(taxel.gain.value_or(mapping.gain) * value + taxel.offset.value_or(mapping.offset));
  }
}

/// Notes the columns of the table that the mapping does not use.
void note_unused_columns(const NumberReader& reader, const Columns& columns, RealRecording& recording) {
  std::set<std::size_t> used(columns.taxels.begin(), columns.taxels.end());
  if (columns.time) used.insert(*columns.time);
  if (const std::string names = reader.names_without(used); !names.empty())
    recording.notes.push_back("columns that are not read: " + names);
}

}  // namespace

RealRecording parse_real_recording(const std::string& text, const ColumnMapping& mapping, const std::string& file) {
  check_mapping(mapping, file);
  const TextTable table = split_table(text, mapping, file);
  const NumberReader reader(table, mapping, file);
  const Columns columns = find_columns(reader, mapping);
  RealRecording recording;
  recording.notes = table.notes;
  note_unused_columns(reader, columns, recording);
  TaxelSeries& series = recording.series;
  series.unit = mapping.unit;
  for (const TaxelColumn& taxel : mapping.taxels) series.taxel_ids.push_back(taxel.taxel);
  series.values.resize(mapping.taxels.size());
  std::size_t again = 0;
  reader.check_widths();
  std::vector<double> times;
  if (columns.time) times = reader.times(*columns.time, recording.notes);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const double time = columns.time ? times[r] : static_cast<double>(r) / mapping.rate;
    if (columns.time && !series.time.empty() && time == series.time.back() && ++again > 0) continue;
    add_row(reader, mapping, columns, table.rows[r], time, series);
  }
  if (series.time.size() < 2)
    throw Error(file, fmt::format("has {} rows of numbers, at least 2 are needed", series.time.size()));
  if (again > 0)
    recording.notes.push_back(fmt::format("{} rows have the time of the row before and are left out", again));
  tell_missing(recording);
  return recording;
}

RealRecording read_real_recording(const std::string& file, const ColumnMapping& mapping) {
  return parse_real_recording(read_file(file), mapping, file);
}

TableLook look_at_table(const std::string& text, const ColumnMapping& mapping, const std::string& file,
                        std::size_t most_rows) {
  TextTable table = split_table(text, mapping, file);
  TableLook look{std::move(table.columns), {}};
  for (std::size_t r = 0; r < std::min(most_rows, table.rows.size()); ++r)
    look.rows.push_back(std::move(table.rows[r].fields));
  return look;
}

}  // namespace taxel
