#include "app/studio/nouns/compare/compare_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/sensor/readout/reading.h"

namespace taxel::ui {

namespace {

double place_of(const ComparedRow& row, bool by_travel) {
  return by_travel ? row.travel : row.time;
}

void include_row(SideSummary& summary, const ComparedRow& row, const std::vector<double>* before, std::size_t which,
                 bool by_travel) {
  const std::vector<double>& readings = row.readings[which];
  summary.peaks.resize(readings.size(), 0.0);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const auto taxel = static_cast<int>(k);
    summary.peaks[k] = std::max(summary.peaks[k], readings[k]);
    if (readings[k] > summary.peak.value) summary.peak = {readings[k], taxel, place_of(row, by_travel)};
    if (before == nullptr || k >= before->size()) continue;
    const double change = std::abs(readings[k] - (*before)[k]);
    if (change > summary.jump.value) summary.jump = {change, taxel, place_of(row, by_travel)};
  }
}

}  // namespace

void extend_side(CompareSide& side, std::span<const ComparedRowPtr> rows, std::size_t which, bool by_travel) {
  for (std::size_t i = side.trace.rows.size(); i < rows.size(); ++i) {
    const ComparedRow& row = *rows[i];
    const bool follows = i > 0 && !row.after_gap;
    include_row(side.summary, row, follows ? &rows[i - 1]->readings[which] : nullptr, which, by_travel);
    side.trace.rows.push_back({row.time, row.travel, row.readings[which]});
  }
  side.summary.responding =
      static_cast<int>(std::count_if(side.summary.peaks.begin(), side.summary.peaks.end(),
                                     [&](double peak) { return peak > kTaxelResponds * side.summary.peak.value; }));
  update_curves(side.curves, side.trace, by_travel);
}

double row_distance(std::span<const ComparedRowPtr> rows, bool by_travel) {
  if (rows.size() < 2) return 0;
  return (place_of(*rows.back(), by_travel) - place_of(*rows.front(), by_travel)) /
         static_cast<double>(rows.size() - 1);
}

std::string comparison_to_csv(std::span<const ComparedRowPtr> rows, const std::vector<int>& ids_a,
                              const std::vector<int>& ids_b) {
  std::string text = "time,travel";
  auto out = std::back_inserter(text);
  for (const int id : ids_a) fmt::format_to(out, ",A/taxel_{}", id);
  for (const int id : ids_b) fmt::format_to(out, ",B/taxel_{}", id);
  text += '\n';
  for (const ComparedRowPtr& row : rows) {
    fmt::format_to(out, "{},{}", row->time, row->travel);
    for (const std::vector<double>& readings : row->readings)
      for (const double reading : readings) fmt::format_to(out, ",{}", reading);
    text += '\n';
  }
  return text;
}

}  // namespace taxel::ui
