#include "app/cli/models_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace taxel::cli {
namespace {

std::string number(const std::optional<double>& value, double scale) {
  return value ? fmt::format("{:.4g}", scale * *value) : "-";
}

}  // namespace

std::vector<double> curve_of(const ModelsReport& report, ReadingModel model, std::size_t taxel) {
  std::vector<double> curve;
  for (const ModelsReport::Row& row : report.rows)
    curve.push_back(row.readings[model].has(taxel) ? row.readings[model].values[taxel] : std::nan(""));
  return curve;
}

std::string missing_of(const ModelsReport& report, ReadingModel model) {
  for (const ModelsReport::Row& row : report.rows)
    if (!row.readings[model].missing.empty()) return row.readings[model].missing;
  return "";
}

std::string models_text(const ModelsReport& report) {
  const Aggregate aggregate = report.model->layout.readout.aggregate;
  std::string text = fmt::format(
      "{} rows of \"{}\" by other models. Correlation and rms are against the exact integral, rms after the best gain "
      "and as a part of its peak; the largest step from row to row is a part of the model's own peak.\n\n",
      report.rows.size(), report.geom);
  text += fmt::format("{:>6} {:<14} {:>12} {:<7} {:>12} {:>8} {:>8}\n", "taxel", "model", "peak", "unit", "correlation",
                      "rms %", "step %");
  std::vector<int> quiet;
  for (std::size_t k = 0; k < report.model->layout.taxels.size(); ++k) {
    const std::vector<double> exact = curve_of(report, ReadingModel::exact, k);
    std::string lines;
    bool any = false;
    for (const ReadingModel model : kReadingModels) {
      const CurveComparison c = compare_curve(curve_of(report, model, k), exact);
      any = any || c.peak > 0;
      lines += fmt::format("{:>6} {:<14} {:>12.5g} {:<7} {:>12} {:>8} {:>8.3g}\n", report.model->layout.taxels[k].id,
                           to_word(model), c.peak, unit_of(model, aggregate), number(c.correlation, 1),
                           number(c.rms, 100), 100 * c.largest_step);
    }
    if (any)
      text += lines;
    else
      quiet.push_back(report.model->layout.taxels[k].id);
  }
  if (!quiet.empty()) text += fmt::format("\nnothing is read by taxels {}\n", fmt::join(quiet, ", "));
  for (const ReadingModel model : kReadingModels)
    if (const std::string why = missing_of(report, model); !why.empty())
      text += fmt::format("{}: {}\n", to_word(model), why);
  return text;
}

std::string models_csv(const ModelsReport& report) {
  std::string text = "time,travel";
  for (const ReadingModel model : kReadingModels)
    for (const Taxel& taxel : report.model->layout.taxels) text += fmt::format(",{}_{}", to_word(model), taxel.id);
  text += "\n";
  for (const ModelsReport::Row& row : report.rows) {
    text += fmt::format("{},{}", row.time, row.travel);
    for (const ReadingModel model : kReadingModels)
      for (std::size_t k = 0; k < report.model->layout.taxels.size(); ++k)
        text += row.readings[model].has(k) ? fmt::format(",{}", row.readings[model].values[k]) : ",";
    text += "\n";
  }
  return text;
}

}  // namespace taxel::cli
